// The texts of a language, from the files of assets/text: looked up by an id, or by the English text itself.
#pragma once

#include "puzzle/language/german_names.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace trembler {

/// The texts of one language. Those of the screens have ids ("title.play"); everything else is looked up by
/// its English text, so that code keeps the sentence that it says. Immutable.
class Catalogue {
public:
    /// Without any text: everything stays English.
    Catalogue() = default;
    /// Reads LANGUAGE.json and every file of the folder LANGUAGE; LANGUAGE/names.json has the names of
    /// objects; messages.json, edits.json, faults.json and scripts.json the texts with gaps that translated()
    /// recognises. Files that are missing or damaged are left out, so their texts stay English.
    Catalogue(std::filesystem::path const& folder, std::string_view language);

    /// The text for an id or an English text; nullptr if there is none. Valid as long as the catalogue.
    [[nodiscard]] char const* find(std::string_view english) const;
    /// A finished English text, such as the message of an exception: looked up as it is, or else by the text
    /// with gaps that it fits ("it would overlap the {}"), the one that leaves the least to the gaps. The
    /// contents of the gaps are translated likewise; "{name}", "{akk}" and "{dat}" in the translation make it
    /// the name of an object, without an article or in that case, and "{own}" leaves it as it is. A place
    /// before it, "wind.lua:12: ", stays. If nothing fits, the text as it is.
    [[nodiscard]] std::string translated(std::string const& english) const;
    [[nodiscard]] GermanNames const& names() const { return names_; }

    /// The pieces of a text between its gaps ("{}", "{:.1f}", "{dat}"), and the specifications in the gaps
    /// ("", ":.1f", "dat"). Other braces are those of a file that the text quotes.
    struct Pieces {
        std::vector<std::string> between; ///< one more than gaps
        std::vector<std::string> gaps;
    };
    [[nodiscard]] static Pieces piecesOf(std::string_view text);

private:
    struct Template {
        Pieces english;
        std::size_t length = 0; // of the text between the gaps
        std::string translation;
    };
    [[nodiscard]] std::string translatedInside(std::string const& argument) const;
    [[nodiscard]] std::string filled(Template const& found, std::vector<std::string> const& arguments) const;

    std::map<std::string, std::string, std::less<>> texts_;
    std::vector<Template> templates_; // the longest first
    GermanNames names_;
};

} // namespace trembler
