// All levels that there are to play, in the order in which they are meant to be played.
#pragma once

#include "runtime/world/registry.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::ui {

struct CatalogEntry {
    std::filesystem::path file;
    std::string id;      ///< path below the levels' folder, for example "first/1-first-contact.json"
    std::string title;   ///< from the file; the file's name if it cannot be read
    std::string trouble; ///< why it cannot be played, for the player; empty if it can
};

/// One folder of levels.
struct CatalogGroup {
    std::string title; ///< for example "First"
    std::vector<CatalogEntry> levels;
};

/// Read once, when it is made. Never throws because of a level.
class LevelCatalog {
public:
    LevelCatalog() = default;
    /// Every *.json below `folder`, grouped by its folder; a number at the start of a name orders it. "first"
    /// comes first. A schema file (*.schema.json) is no level.
    LevelCatalog(Registry const& registry, std::filesystem::path const& folder);

    [[nodiscard]] std::vector<CatalogGroup> const& groups() const { return groups_; }
    [[nodiscard]] std::size_t size() const;
    /// The level in that file, or nullptr if it is not in the catalog.
    [[nodiscard]] CatalogEntry const* find(std::filesystem::path const& file) const;
    /// The playable level after it, in its group or the next, or nullptr.
    [[nodiscard]] CatalogEntry const* after(std::filesystem::path const& file) const;

private:
    std::vector<CatalogGroup> groups_;
};

/// True if `a` stands before `b` where digits count as numbers ("2-x" before "10-x").
[[nodiscard]] bool naturallyBefore(std::string_view a, std::string_view b);

} // namespace trembler::ui
