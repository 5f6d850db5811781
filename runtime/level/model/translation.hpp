// The texts of a level or a part in further languages.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace trembler {

/// The texts of a file for people, in one language. An empty text: that of the file itself applies.
struct Translation {
    std::string title;
    std::string text;
    std::vector<std::string> hints;           ///< of a level; instead of all its hints
    std::map<std::string, std::string> goals; ///< of a level: text by the id of a goal

    bool operator==(Translation const&) const = default;
};

/// By language: "de".
using Translations = std::map<std::string, Translation>;

/// The title in a language, else `usual`.
[[nodiscard]] inline std::string titleIn(Translations const& texts, std::string const& language,
                                         std::string const& usual) {
    auto const found = texts.find(language);
    return found == texts.end() || found->second.title.empty() ? usual : found->second.title;
}
/// The same for the text.
[[nodiscard]] inline std::string textIn(Translations const& texts, std::string const& language,
                                        std::string const& usual) {
    auto const found = texts.find(language);
    return found == texts.end() || found->second.text.empty() ? usual : found->second.text;
}

} // namespace trembler
