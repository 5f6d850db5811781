// Checks which parts a player may place where, and names the placed objects.
#pragma once

#include "runtime/level/model/level.hpp"
#include "runtime/level/model/part_library.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace trembler {

/// Why `candidate` may not be placed in addition to `others`, in words for the player; nothing if it may. Its
/// part must exist and be left in the toolbox, and its centre must lie in one of the areas for placing (if
/// none are stated, anywhere within the level's bounds). Overlaps, and whether the whole outline of a part
/// that a player places lies there, are not checked here, as shapes are physics.
[[nodiscard]] std::optional<std::string> checkPlacement(LevelFile const& level, PartLibrary const& library,
                                                        std::span<Placement const> others,
                                                        Placement const& candidate);

/// The same for many placements, each in addition to all previous ones, allowed or not. Their parts are
/// counted, so that n placements take n times as long as one. The level and the library must outlive it.
class PlacementCount {
public:
    PlacementCount(LevelFile const& level, PartLibrary const& library);
    /// Why `candidate` may not be placed, as in checkPlacement(); counts it in any case.
    [[nodiscard]] std::optional<std::string> add(Placement const& candidate);

private:
    LevelFile const& level_;
    PartLibrary const& library_;
    std::map<std::string, std::size_t, std::less<>> used_; // by part
};

/// The canonical order: by part, then x, y, angle and flipped; equal placements keep their order. Ids and
/// names follow this order, so that the order in which a player placed the parts never matters. Returns the
/// indices of `placements` in that order.
[[nodiscard]] std::vector<std::size_t> canonicalOrder(std::span<Placement const> placements);
/// The placements themselves in that order, with 0 for -0.
[[nodiscard]] std::vector<Placement> inCanonicalOrder(std::span<Placement const> placements);

/// The names of the objects made from placements, in canonical order: the part's name and a number, from 1,
/// leaving out names of the level's own objects.
[[nodiscard]] std::vector<std::string> placementNames(LevelFile const& level,
                                                      std::span<Placement const> placements);
/// The same where other names are taken.
[[nodiscard]] std::vector<std::string> placementNames(std::set<std::string> const& taken,
                                                      std::span<Placement const> placements);

} // namespace trembler
