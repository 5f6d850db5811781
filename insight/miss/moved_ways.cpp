#include "insight/miss/moved_ways.hpp"

#include "puzzle/goals/conditions/moved.hpp"
#include "runtime/placement.hpp"

namespace trembler::insight {

std::vector<MovedWay> movedWays(ConditionMiss const& one, World const& world) {
    conditions::WantedMove const wanted = conditions::wantedMove(one.state().condition());
    bool const anyDirection = wanted.towards == Vec2{};
    std::vector<MovedWay> ways;
    for (std::size_t i = 0; i < one.starts().size(); ++i) {
        ObjectId const id = one.state().subjects()[i];
        if (Position const* const position = world.find<Position>(id)) {
            Vec2 const way = position->value - one.starts()[i];
            ways.push_back({id, position->value, way, anyDirection ? length(way) : dot(way, wanted.towards)});
        }
    }
    return ways;
}

} // namespace trembler::insight
