// All playable levels, in the order in which they are meant to be played.
#pragma once

#include "puzzle/campaign/progress.hpp"
#include "puzzle/data/game_data.hpp"
#include "runtime/world/registry.hpp"

#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::ui {

struct CatalogEntry {
    std::filesystem::path file;
    std::string id;             ///< path below the levels' folder, for example "first/1-first-contact.json"
    std::string title;          ///< from the file; the file's name if it cannot be read
    std::string trouble;        ///< why it cannot be played, as a sentence for the player; empty if it can
    bool demonstration = false; ///< reaches its goals by itself
    bool task = false;          ///< a demonstration with something to do
    Translations texts{};       ///< its title in further languages
};

/// One folder of levels.
struct CatalogGroup {
    std::string title; ///< for example "First steps"
    std::string text;  ///< a sentence below it, or the reason why its chapter.json cannot be read
    bool gallery = false;
    std::vector<CatalogEntry> levels;
    Translations texts{}; ///< title and text in further languages
};

/// The stars of several levels.
struct StarCount {
    int won = 0;
    /// Of the stars that are shown for each level before they are reached (shownStars): a third star of one
    /// level does not stand for the second of another.
    int missing = 0;
};

/// Levels that name mods, and levels of mods.
struct CatalogMods {
    /// The data for reading a level, nullptr if it names no mods; throws InputError. Empty: a level that
    /// names mods cannot be played.
    std::function<std::shared_ptr<GameData const>(std::filesystem::path const&)> data{};
    std::vector<std::filesystem::path> mods{}; ///< each the folder of a mod: its levels are listed, too
};

/// What an entry says of an error: its first fault, in the player's language, of limited length.
[[nodiscard]] std::string troubleFrom(std::exception const& error);

/// Reads all levels once, in the constructor. A faulty level never throws: it is listed with its trouble.
/// Whether a world can be built from it takes longer: that is found when its picture is drawn, see
/// noteTrouble().
class LevelCatalog {
public:
    LevelCatalog() = default;
    /// Every level below `folder`, grouped by its folder; a number at the start of a name determines its
    /// place. A folder's chapter.json states its title and its place among the groups, see chapter.hpp.
    /// Those of mods come last, a group for each mod.
    LevelCatalog(Registry const& registry, std::filesystem::path const& folder, CatalogMods const& mods = {});

    [[nodiscard]] std::vector<CatalogGroup> const& groups() const { return groups_; }
    [[nodiscard]] std::size_t size() const;
    /// The entry of a file, or nullptr if it is not in the catalog.
    [[nodiscard]] CatalogEntry const* find(std::filesystem::path const& file) const;
    /// The next playable level after the file, in its group or a later one, or nullptr. After a puzzle
    /// comes no demonstration of a gallery, and after a demonstration only another of its gallery.
    [[nodiscard]] CatalogEntry const* after(std::filesystem::path const& file) const;
    /// The puzzle to play next: the first playable one after the file that is not solved, else the first of
    /// all that is not; nullptr if all are. Empty `file`: the first that is not solved. After a demonstration
    /// of a gallery the same as after().
    [[nodiscard]] CatalogEntry const* next(CampaignProgress const& progress,
                                           std::filesystem::path const& file = {}) const;
    /// To be called when it turns out that a level cannot be played.
    void noteTrouble(std::string const& id, std::string const& why);
    /// Whether the file is a level of a gallery of demonstrations.
    [[nodiscard]] bool inGallery(std::filesystem::path const& file) const;
    /// Of all playable puzzles, demonstrations of galleries and levels of mods not among them.
    [[nodiscard]] StarCount stars(CampaignProgress const& progress) const;

private:
    [[nodiscard]] CatalogGroup const* groupOf(CatalogEntry const* entry) const;

    std::vector<CatalogGroup> groups_;
    std::size_t ofMods_ = 0; // groups at the end that are those of mods
};

/// Whether `a` comes before `b` if digits are compared as numbers ("2-x" before "10-x").
[[nodiscard]] bool naturallyBefore(std::string_view a, std::string_view b);

} // namespace trembler::ui
