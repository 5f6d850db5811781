// The names of objects in German: with gender, article and case, as sentences need them.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trembler {

enum class GermanCase { nominative, accusative, dative };

/// Knows nouns with their articles, adjectives that may stand before them ("left", "second"), and words that
/// may stand behind them ("wall left"). Any name of these is understood: "second left lamp", "wall left",
/// "lamp 2", and that of a piece, "doorbell striker".
class GermanNames {
public:
    GermanNames() = default;
    /// {"nouns": {"lamp": "die Lampe", "ball": "die Kugel|Kugeln", "magnet": "der Magnet|Magnete|Magneten"},
    /// "adjectives": {"left": "link"}, "behind": {"left": "links"}}. Behind the first bar is the plural,
    /// behind the second one the form in the accusative and the dative, of nouns that have another one there;
    /// either may be missing. Entries of another form are left out.
    explicit GermanNames(nlohmann::json const& file);

    /// "linke Lampe"; a name that is not understood is returned as it is.
    [[nodiscard]] std::string bare(std::string const& name) const;
    /// "die linke Lampe", "der linken Lampe", "den Magneten"; without an article before a number, as in
    /// "Lampe 2", and for names that are not understood.
    [[nodiscard]] std::string definite(std::string const& name, GermanCase use) const;
    /// "eine Lampe", "einem Amboss".
    [[nodiscard]] std::string indefinite(std::string const& name, GermanCase use) const;
    /// "Kugeln"; without a known plural the noun itself.
    [[nodiscard]] std::string plural(std::string const& name, GermanCase use) const;
    [[nodiscard]] bool understands(std::string const& name) const { return parsed(name).has_value(); }

private:
    struct Noun {
        std::string article; // in the nominative; "" after none
        std::string word;
        std::string plural;
        std::string oblique; // in the accusative and the dative; "" as in the nominative

        /// Behind an article or an adjective.
        [[nodiscard]] std::string const& in(GermanCase use) const {
            return use == GermanCase::nominative || oblique.empty() ? word : oblique;
        }
    };
    struct Parsed {
        std::vector<std::string> adjectives; // stems
        Noun noun;
        std::string behind; // " links", " 2", or nothing
        bool numbered = false;
    };
    [[nodiscard]] std::optional<Parsed> parsed(std::string_view name) const;

    std::map<std::string, Noun, std::less<>> nouns_;
    std::map<std::string, std::string, std::less<>> adjectives_;
    std::map<std::string, std::string, std::less<>> behind_;
};

} // namespace trembler
