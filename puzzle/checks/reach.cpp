// Complains about objects and areas that no player can reach or see: see level_checks.hpp.
#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/dynamics/properties/shapes/placed_shape.hpp"
#include "puzzle/checks/level_checks.hpp"
#include "puzzle/goals/read_goals.hpp"
#include "puzzle/session/fit.hpp"
#include "puzzle/session/zone.hpp"
#include "runtime/level/json/add_problem.hpp"
#include "runtime/world/world.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace trembler {
namespace {

class ReachCheck {
public:
    ReachCheck(GameData const& data, LevelFile const& level, World const& world, Problems& problems)
        : data_(data), level_(level), world_(world), problems_(problems) {}

    void checkObjects() {
        Bounds const bounds = boundsOf(Area{level_.bounds, {}});
        for (LevelObject const& object : level_.objects) {
            ObjectId const id = world_.store().find(object.name);
            auto const placed = placedShapeOf(world_.store(), id);
            if (!placed || world_.find<Liquid>(id) != nullptr) {
                continue;
            }
            auto const [low, high] = extentOf(*placed);
            if (!bounds.meets({low, high})) {
                complain(object.path.empty() ? "" : object.path + "/at",
                         fmt::format("'{}' lies outside the bounds of the level", object.name),
                         "a place within \"bounds\", or larger bounds");
            }
        }
    }

    void checkAreas() {
        Bounds const bounds = boundsOf(Area{level_.bounds, {}});
        std::size_t const count = level_.placing ? level_.placing->size() : 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (!bounds.meets(boundsOf((*level_.placing)[i]))) {
                complain(fmt::format("/placing/{}", i),
                         "this area for placing lies outside the bounds of the level",
                         "an area within \"bounds\"");
            }
        }
        Problems ignored; // goals and task have been read before
        for (auto const& condition : {readGoals(level_, ignored), readTask(level_, ignored)}) {
            if (condition) {
                checkGoal(*condition, bounds);
            }
        }
    }

    void checkToolbox() {
        if (!level_.placing || level_.toolbox.empty()) {
            return;
        }
        if (level_.placing->empty()) {
            complain("/placing", "there is a toolbox, but no area where parts may be placed",
                     "at least one area, or no \"placing\": then anywhere within the bounds");
            return;
        }
        for (ToolboxEntry const& entry : level_.toolbox) {
            if (!isPlacedBySolution(entry.part) && !hasRoom(entry.part)) {
                complain(entry.path,
                         fmt::format("there is no room for '{}' in any area for placing", entry.part),
                         "an area in which the whole part lies and overlaps nothing");
            }
        }
    }

private:
    [[nodiscard]] bool isPlacedBySolution(std::string const& part) const {
        return std::any_of(level_.solutions.begin(), level_.solutions.end(), [&](Solution const& solution) {
            return std::any_of(solution.placements.begin(), solution.placements.end(),
                               [&](Placement const& placement) { return placement.part == part; });
        });
    }

    /// Tries places on ever finer grids, as nearly every area has room at once.
    [[nodiscard]] bool hasRoom(std::string const& part) const {
        constexpr std::array<int, 3> grids{1, 6, 30};
        constexpr std::array<double, 4> angles{0, pi / 2, pi / 4, -pi / 4};
        for (int const steps : grids) {
            for (double const angle : angles) {
                bool const found =
                    std::any_of(level_.placing->begin(), level_.placing->end(),
                                [&](Area const& area) { return hasRoomIn(area, part, angle, steps); });
                if (found) {
                    return true;
                }
            }
        }
        return false;
    }

    [[nodiscard]] bool hasRoomIn(Area const& area, std::string const& part, double angle, int steps) const {
        Bounds const reach = boundsOf(area);
        Vec2 const size = reach.upper - reach.lower;
        for (int i = 0; i < steps; ++i) {
            for (int j = 0; j < steps; ++j) {
                Placement placement{part, {}, angle, {}};
                placement.at = reach.lower + Vec2{size.x * (i + 0.5) / steps, size.y * (j + 0.5) / steps};
                if (area.contains(placement.at) && !whyItSticksOut(level_, data_.parts, placement) &&
                    !whyItDoesNotFit(world_, data_.parts, placement, {})) {
                    return true;
                }
            }
        }
        return false;
    }

    void checkGoal(Condition const& condition, Bounds const& bounds) {
        if (condition.area && !bounds.meets(boundsOf(*condition.area))) {
            complain(condition.path, "the area of this goal lies outside the bounds of the level",
                     "an area within \"bounds\", or larger bounds");
        }
        for (Condition const& child : condition.children) {
            checkGoal(child, bounds);
        }
    }

    void complain(std::string path, std::string message, std::string expected) {
        addProblem(problems_, [&] {
            return level_.diagnostic(std::move(path), std::move(message), std::move(expected));
        });
    }

    GameData const& data_;
    LevelFile const& level_;
    World const& world_;
    Problems& problems_;
};

} // namespace

void complainAboutReach(GameData const& data, LevelFile const& level, World const& world,
                        Problems& problems) {
    ReachCheck check(data, level, world, problems);
    if (level.bounds) {
        check.checkObjects();
        check.checkAreas();
    }
    check.checkToolbox();
}

} // namespace trembler
