// Complains about so many bodies in one place that frames take long: see level_checks.hpp.
#include "physics/dynamics/properties/crowd.hpp"
#include "puzzle/checks/level_checks.hpp"
#include "runtime/level/json/add_problem.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler {

bool complainAboutCrowds(LevelFile const& level, World const& world, Problems& problems) {
    std::optional<CrowdedStart> const crowd = crowdedStart(world.store());
    if (!crowd) {
        return false;
    }
    std::string const name = world.store().nameOf(crowd->body);
    auto const object = std::find_if(level.objects.begin(), level.objects.end(),
                                     [&](LevelObject const& one) { return one.name == name; });
    std::string const path =
        object == level.objects.end() || object->path.empty() ? "/objects" : object->path + "/at";
    addProblem(problems, [&] {
        return level.diagnostic(
            path, inWords(*crowd, name),
            fmt::format("at most {} pairs, with as many bodies that can move as here", crowd->usual));
    });
    return true;
}

} // namespace trembler
