// The texts of the screens in the player's language, from assets/text.
#pragma once

#include "puzzle/language/catalogue.hpp"
#include "puzzle/language/speech.hpp"

#include <fmt/format.h>

#include <locale>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::ui {

/// A language that the program speaks.
struct Language {
    std::string_view id;   ///< "en", as in settings and names of files
    std::string_view name; ///< "English", in itself
};
[[nodiscard]] std::span<Language const> languages();

/// That of the desktop, from LC_ALL, LC_MESSAGES or LANG; English if the program does not speak it.
[[nodiscard]] std::string_view languageOfDesktop();

/// Reads the texts of a language; "" or one that the program does not speak: that of the desktop. Texts that
/// are missing there, or all if the file is damaged, are shown in English. Window thread only; ends the
/// validity of all texts that text() has returned.
void useLanguage(std::string_view id);
/// The id of the language in use.
[[nodiscard]] std::string_view languageInUse();

/// The text with that id, or the translation of that English text; without one `id` itself, which a test
/// excludes. Without a call of useLanguage() in English. Window thread only.
[[nodiscard]] char const* text(std::string_view id);
/// The text with that id in a language that the program speaks, whichever is in use.
[[nodiscard]] std::string textOfLanguage(std::string_view language, std::string_view id);
/// With the decimal point of the language in use, for "{:.1Lf}".
[[nodiscard]] std::locale const& numberLocale();
/// The text with "{}" replaced by the arguments. One that does not take them is returned as it is.
template <class... Arguments>
[[nodiscard]] std::string textWith(std::string_view id, Arguments const&... arguments) {
    try {
        return fmt::format(numberLocale(), fmt::runtime(text(id)), arguments...);
    } catch (fmt::format_error const&) {
        return text(id);
    }
}

/// The translation of an English message from a part of the program without a window, such as a reason with
/// the names of objects: Catalogue::translated() of the language in use.
[[nodiscard]] std::string translated(std::string const& english);
/// The name of an object: "linke Lampe".
[[nodiscard]] std::string shownName(std::string const& object);
/// An area as its level calls it, where it is marked: "the basket", "Korb".
[[nodiscard]] std::string shownArea(std::string const& called);
/// As the object of a verb or behind a preposition, with its article: "the left lamp".
[[nodiscard]] Noun theObject(std::string const& object);
/// The grammar of the language in use, valid until useLanguage().
[[nodiscard]] Speech const& speechInUse();
/// A number that is written with a decimal point, with that of the language in use.
[[nodiscard]] std::string localNumber(std::string number);

/// A text of the program that converts itself into the language in use wherever it is read. Made of a literal
/// in English.
class Phrase {
public:
    template <std::size_t size>
    consteval Phrase(char const (&english)[size]) : english_(english) {} // NOLINT: as if it were the literal
    consteval Phrase(std::nullptr_t) : english_(nullptr) {}              // NOLINT: no text

    operator char const*() const { return english_ == nullptr ? nullptr : text(english_); } // NOLINT
    operator std::string() const { return text(english_); } // NOLINT: not of nullptr
    [[nodiscard]] constexpr char const* english() const { return english_; }
    friend std::string operator+(std::string before, Phrase const& phrase) {
        return before += static_cast<char const*>(phrase);
    }
    friend std::string operator+(Phrase const& phrase, std::string const& behind) {
        return static_cast<char const*>(phrase) + behind;
    }

private:
    char const* english_;
};

/// A constant for the place where a text is shown: a pointer to its English text, which follows the language
/// in use. `english` must be a literal.
[[nodiscard]] char const* const& said(char const* english);
/// The English texts of all such constants.
[[nodiscard]] std::vector<char const*> allSaid();

} // namespace trembler::ui

template <>
struct fmt::formatter<trembler::ui::Phrase> : formatter<char const*> {
    template <class Context>
    auto format(trembler::ui::Phrase const& phrase, Context& context) const {
        return formatter<char const*>::format(static_cast<char const*>(phrase), context);
    }
};
