// The texts of the screens in the player's language, from assets/text/LANGUAGE.json.
#pragma once

#include <fmt/format.h>

#include <span>
#include <string>
#include <string_view>

namespace trembler::ui {

/// A language that the program speaks.
struct Language {
    std::string_view id;   ///< "en", as in settings and names of files
    std::string_view name; ///< "English", in itself
};
[[nodiscard]] std::span<Language const> languages();

/// That of the desktop, from LC_ALL, LC_MESSAGES or LANG; English if the program does not speak it.
[[nodiscard]] std::string_view languageOfDesktop();

/// Reads the texts of a language; "" or one that the program does not speak: that of the desktop. What has no
/// text there, or if the file is damaged, is shown in English. Window thread only; ends the validity of all
/// texts that text() has returned.
void useLanguage(std::string_view id);
/// The id of the language in use.
[[nodiscard]] std::string_view languageInUse();

/// The text with that id; the id itself if there is none, which a test excludes. Without a call of
/// useLanguage() in English. Window thread only.
[[nodiscard]] char const* text(std::string_view id);
/// The text with "{}" replaced by the arguments. One that does not take them is returned as it is.
template <class... Arguments>
[[nodiscard]] std::string textWith(std::string_view id, Arguments const&... arguments) {
    try {
        return fmt::format(fmt::runtime(text(id)), arguments...);
    } catch (fmt::format_error const&) {
        return text(id);
    }
}

} // namespace trembler::ui
