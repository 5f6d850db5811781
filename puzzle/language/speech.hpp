// How a language says the parts of sentences about goals: the grammar that words alone do not settle.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace trembler {

class Catalogue;

/// Objects in words, as parts of a sentence.
struct Noun {
    std::string words; ///< "the lamp"; as the object of a verb
    bool plural = false;
    std::string dative{}; ///< where the language has one
};

/// English; other languages derive from it. Stateless.
class Speech {
public:
    Speech() = default;
    virtual ~Speech() = default;
    Speech(Speech const&) = delete;
    Speech& operator=(Speech const&) = delete;

    /// An English phrase with a noun for each "{}", as the language says it.
    [[nodiscard]] virtual std::string phrase(std::string_view english,
                                             std::initializer_list<Noun> nouns = {}) const;
    /// "the lamp"; names such as "object 1" and "Bob" get no article.
    [[nodiscard]] virtual Noun the(std::string const& name) const;
    /// An area as the level calls it: "the basket".
    [[nodiscard]] virtual Noun area(std::string const& called) const;
    /// "a steel bar", of a part
    [[nodiscard]] virtual Noun a(std::string const& part) const;
    /// "the steel bars", of a part
    [[nodiscard]] virtual Noun all(std::string const& part) const;
    /// "two steel bars", "no steel bars", of a part; with the prefix, such as "at least "
    [[nodiscard]] virtual Noun some(std::string const& prefix, int number, std::string const& part) const;
    /// "two of A, B and C", "none of A and B"
    [[nodiscard]] virtual Noun someOf(std::string const& prefix, int number,
                                      std::vector<Noun> const& items) const;
    /// "both A and B", "all of A, B and C"
    [[nodiscard]] virtual Noun everyOne(std::vector<Noun> const& items) const;
    /// "A, B and C", where `last` is the English word before the last item, such as "and".
    [[nodiscard]] virtual Noun list(std::vector<Noun> const& items, std::string const& last) const;
    [[nodiscard]] virtual std::string number(double value) const;
};

/// The one of the program's own texts.
[[nodiscard]] Speech const& englishSpeech();

/// German, with the phrases and names of a catalogue, which must outlive it.
class GermanSpeech final : public Speech {
public:
    explicit GermanSpeech(Catalogue const& catalogue) : catalogue_(catalogue) {}

    [[nodiscard]] std::string phrase(std::string_view english,
                                     std::initializer_list<Noun> nouns) const override;
    [[nodiscard]] Noun the(std::string const& name) const override;
    [[nodiscard]] Noun area(std::string const& called) const override;
    [[nodiscard]] Noun a(std::string const& part) const override;
    [[nodiscard]] Noun all(std::string const& part) const override;
    [[nodiscard]] Noun some(std::string const& prefix, int number, std::string const& part) const override;
    [[nodiscard]] Noun someOf(std::string const& prefix, int number,
                              std::vector<Noun> const& items) const override;
    [[nodiscard]] Noun everyOne(std::vector<Noun> const& items) const override;
    [[nodiscard]] Noun list(std::vector<Noun> const& items, std::string const& last) const override;
    [[nodiscard]] std::string number(double value) const override;

private:
    Catalogue const& catalogue_;
};

} // namespace trembler
