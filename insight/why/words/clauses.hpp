// The clauses of which sentences about causes consist, in the player's language.
#pragma once

#include "insight/why/answer.hpp"
#include "puzzle/language/catalogue.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::insight {

/// The content of a gap of a text.
struct Said {
    std::string text;
    bool isName = false; ///< of an object: gets an article and a case
};

/// A language: English, or that of a catalogue, which must outlive it. Thread-safe.
class AnswerLanguage {
public:
    /// English.
    AnswerLanguage() = default;
    explicit AnswerLanguage(Catalogue const& catalogue) : catalogue_(&catalogue) {}
    /// The same, which calls objects as SceneFacts::spoken says; `spoken` must outlive it.
    [[nodiscard]] AnswerLanguage calling(std::map<std::string, std::string> const& spoken) const {
        AnswerLanguage language = *this;
        language.spoken_ = &spoken;
        return language;
    }

    /// An English text with the content for each "{}"; in the translation, "{akk}" and "{dat}" are cases.
    [[nodiscard]] std::string mix(std::string_view english, std::vector<Said> const& said) const;
    /// The same with a name for each gap.
    [[nodiscard]] std::string say(std::string_view english, std::vector<std::string> const& names = {}) const;
    /// The same with finished words in place of names.
    [[nodiscard]] std::string fill(std::string_view english, std::vector<std::string> const& words) const;
    /// "the lamp" or "die Lampe", as a subject.
    [[nodiscard]] std::string the(std::string const& name) const;
    /// "0.4" or "0,4".
    [[nodiscard]] std::string number(double value, int digits) const;
    /// "4 cm", "0.4 m", rounded as people would.
    [[nodiscard]] std::string distance(double metres) const;
    /// A whole sentence as it is written after a colon: in German with a capital letter.
    [[nodiscard]] std::string afterColon(std::string sentence) const;

private:
    [[nodiscard]] std::string const& called(std::string const& name) const;

    Catalogue const* catalogue_ = nullptr;
    std::map<std::string, std::string> const* spoken_ = nullptr;
};

/// With a capital letter, if it begins with a letter of ASCII.
[[nodiscard]] std::string capitalised(std::string text);

/// A step as a sentence without a full stop and as the clause after another one: "the spanner
/// touches the left contact" and "because the spanner touches the left contact".
struct Clauses {
    std::string main;
    std::string because;
};
[[nodiscard]] Clauses clausesOf(Step const& step, SceneFacts const& facts, std::string const& goal,
                                AnswerLanguage const& language);

} // namespace trembler::insight
