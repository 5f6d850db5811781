#include "insight/search/random_placement.hpp"

#include "insight/search/wire_ends.hpp"
#include "insight/trial/trial.hpp"
#include "physics/dynamics/properties/shapes/overlap.hpp"
#include "puzzle/session/fit.hpp"
#include "puzzle/session/zone.hpp"
#include "runtime/placement.hpp"
#include "runtime/property/for_each.hpp"

#include <algorithm>
#include <limits>

namespace trembler::insight {
namespace {

constexpr int placesTried = 64;
constexpr std::size_t mostRandomParts = 4;
constexpr std::size_t turns = 24; // of 15 degrees each

Box boxOf(Bounds const& bounds) {
    return {bounds.lower, bounds.upper - bounds.lower};
}

Box boxAround(Area const& area) {
    return area.box ? *area.box : boxOf(boundsOf(area));
}

Box boxAround(World const& world) {
    std::vector<Vec2> corners;
    auto const* const positions = world.store().findColumn<Position>();
    if (positions != nullptr) {
        forEach([&](ObjectId, Position const& position) { corners.push_back(position.value); }, *positions);
    }
    if (corners.empty()) {
        corners.emplace_back();
    }
    Box const box = boxOf(boundsOf(corners));
    return {box.corner - Vec2{1, 1}, box.size + Vec2{2, 2}};
}

} // namespace

std::vector<Area> placingAreas(LevelUnderTest const& level) {
    if (level.level().placing) {
        return *level.level().placing;
    }
    return {Area{level.level().bounds ? *level.level().bounds : boxAround(level.world()), {}}};
}

int leftInToolbox(LevelUnderTest const& level, Solution const& solution, std::string const& part) {
    auto const used = std::count_if(solution.placements.begin(), solution.placements.end(),
                                    [&](Placement const& placement) { return placement.part == part; });
    for (ToolboxEntry const& entry : level.level().toolbox) { // which has every part once
        if (entry.part == part) {
            return leftOf(entry.count, static_cast<int>(used));
        }
    }
    return -static_cast<int>(used);
}

namespace {

/// `wholly`: in the areas, and not only with its centre.
std::optional<Placement> anywhere(LevelUnderTest const& level, Solution const& others,
                                  std::string const& part, CounterRandom& random, bool wholly) {
    std::vector<Area> const areas = placingAreas(level);
    if (areas.empty() || leftInToolbox(level, others, part) < 1) {
        return std::nullopt;
    }
    double total = 0;
    for (Area const& area : areas) {
        Box const box = boxAround(area);
        total += box.size.x * box.size.y;
    }
    for (int n = 0; n < placesTried; ++n) {
        double at = random.between(0, total);
        std::size_t chosen = 0;
        for (; chosen + 1 < areas.size(); ++chosen) {
            Box const box = boxAround(areas[chosen]);
            if (at < box.size.x * box.size.y) {
                break;
            }
            at -= box.size.x * box.size.y;
        }
        Box const box = boxAround(areas[chosen]);
        Placement placement;
        placement.part = part;
        placement.at = box.corner + Vec2{box.size.x * random.unit(), box.size.y * random.unit()};
        std::size_t const turn = random.chance(0.5) ? 0 : random.below(turns);
        placement.angle = static_cast<double>(turn) * pi / 12;
        if (!areas[chosen].contains(placement.at) ||
            (wholly && whyItSticksOut(level.level(), level.data().parts, placement)) ||
            whyItDoesNotFit(level.world(), level.data().parts, placement, {})) {
            continue;
        }
        Solution together = others;
        together.placements.push_back(placement);
        if (others.placements.empty() || !whyNotPlaced(level, together)) {
            return placement;
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<Placement> droppedAtRandom(LevelUnderTest const& level, Solution const& others,
                                         std::string const& part, CounterRandom& random) {
    return anywhere(level, others, part, random, false);
}

std::optional<Placement> placedAtRandom(LevelUnderTest const& level, Solution const& others,
                                        std::string const& part, CounterRandom& random) {
    return anywhere(level, others, part, random, true);
}

Solution randomSolution(LevelUnderTest const& level, CounterRandom& random) {
    Solution solution;
    std::vector<ToolboxEntry> const& toolbox = level.level().toolbox;
    std::size_t const count = toolbox.empty() ? 0 : 1 + random.below(mostRandomParts);
    for (std::size_t n = 0; n < count; ++n) {
        std::string const& part = toolbox[random.below(toolbox.size())].part;
        if (auto const placement = placedAtRandom(level, solution, part, random)) {
            solution.placements.push_back(*placement);
        }
    }
    addRandomWires(level, solution, random);
    return solution;
}

} // namespace trembler::insight
