// The names of placed objects in a run that does without some of the placements.
#pragma once

#include "puzzle/session/renaming.hpp"
#include "runtime/level/model/level.hpp"

#include <cstddef>
#include <set>
#include <span>
#include <string>

namespace trembler::insight {

/// Names are numbered in the order of places, so others of the same part get other names: without "cork 1",
/// "cork 2" is "cork 1". Pieces of composite parts follow their part: "scale 2 pan".
class PlacedNames {
public:
    /// All names stay.
    PlacedNames() = default;
    /// Without the placements whose indices are `gone`, each below placements.size().
    PlacedNames(LevelFile const& level, std::span<Placement const> placements,
                std::set<std::size_t> const& gone);

    /// The name in the reduced run of an object of the whole one; a name that no object has if its
    /// placement is gone. Names of the level's own objects stay.
    [[nodiscard]] std::string inReduced(std::string const& name) const;
    /// The name in the whole run of an object of the reduced one.
    [[nodiscard]] std::string inWhole(std::string const& name) const;
    /// Whether the object, by its name in the whole run, came from a placement that is gone.
    [[nodiscard]] bool isGone(std::string const& name) const;
    /// Whether no name changes.
    [[nodiscard]] bool empty() const { return renamed_.empty(); }

private:
    Renaming renamed_; // from the whole run to the reduced one
};

} // namespace trembler::insight
