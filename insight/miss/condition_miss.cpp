#include "insight/miss/condition_miss.hpp"

#include "insight/miss/area_distance.hpp"
#include "insight/miss/current/current_miss.hpp"
#include "insight/miss/moved_ways.hpp"
#include "insight/miss/negated_miss.hpp"
#include "insight/miss/obstacles.hpp"
#include "physics/dynamics/properties/shapes/placed_shape.hpp"
#include "puzzle/goals/conditions/count.hpp"
#include "puzzle/goals/conditions/moved.hpp"
#include "puzzle/goals/conditions/sequence.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace trembler::insight {
namespace {

/// The share of a measure that a condition keeps while it holds, but not yet for long enough.
constexpr double shareOfTime = 0.3;

double measureOf(double distance) {
    return distance / (distance + typicalDistance);
}

Miss met() {
    Miss made;
    made.measure = 0;
    made.lack = Lack::nothing;
    return made;
}

Miss otherWayRound(ConditionState const& state) {
    Miss made;
    made.by = 1;
    made.objects = state.subjects();
    return made;
}

void keepNearer(Miss& best, Miss const& other) {
    if (other.measure < best.measure) {
        best = other;
    }
}

Miss missOfInside(ConditionMiss const& one, World const& world, CircuitSight& circuits) {
    Miss best = otherWayRound(one.state());
    for (ObjectId const id : one.state().subjects()) {
        if (Position const* const position = world.find<Position>(id)) {
            Miss miss;
            miss.lack = Lack::distance;
            miss.from = position->value;
            miss.to = nearestIn(*one.state().condition().area, position->value);
            miss.by = length(miss.to - miss.from);
            miss.measure = measureOf(miss.by);
            miss.objects = {id};
            keepNearer(best, miss);
        }
    }
    addObstacles(best, world, circuits);
    return best;
}

Miss missOfTouching(ConditionMiss const& one, World const& world, CircuitSight& circuits) {
    Miss best = otherWayRound(one.state());
    for (ObjectId const a : one.state().subjects()) {
        auto const shapeA = placedShapeOf(world.store(), a);
        for (ObjectId const b : one.state().objects()) {
            auto const shapeB = placedShapeOf(world.store(), b);
            if (!shapeA || !shapeB || a == b) {
                continue;
            }
            ShapeGap const gap = gapBetween(*shapeA, *shapeB);
            Miss miss;
            miss.lack = Lack::distance;
            miss.by = gap.width;
            miss.from = gap.a;
            miss.to = gap.b;
            miss.measure = measureOf(miss.by);
            miss.objects = {a, b};
            keepNearer(best, miss);
        }
    }
    if (one.state().objects().empty() && best.lack == Lack::change) {
        best.lack = Lack::absent;
    }
    addObstacles(best, world, circuits);
    return best;
}

Miss missOfMoved(ConditionMiss const& one, World const& world, CircuitSight& circuits) {
    conditions::WantedMove const wanted = conditions::wantedMove(one.state().condition());
    Miss best = otherWayRound(one.state());
    for (MovedWay const& moved : movedWays(one, world)) {
        Miss miss;
        miss.lack = Lack::distance;
        miss.by = std::max(0.0, wanted.distance - moved.done);
        miss.measure = std::clamp(miss.by / (miss.by + wanted.distance), 0.0, 1.0);
        miss.objects = {moved.object};
        miss.from = moved.at;
        miss.to = moved.at + wanted.towards * miss.by; // the same place if any direction will do
        keepNearer(best, miss);
    }
    addObstacles(best, world, circuits);
    return best;
}

Miss missOfCurrent(ConditionMiss const& one, World const& world, CircuitSight& circuits) {
    return missOfOn(one.state(), world, circuits);
}

Miss missOfNoCurrent(ConditionMiss const& one, World const& world, CircuitSight& /*circuits*/) {
    return missOfOff(one.state(), world);
}

Miss missOfNegation(ConditionMiss const& one, World const& world, CircuitSight& circuits) {
    return one.children().empty() ? otherWayRound(one.state())
                                  : negatedMiss(one.children().front(), world, circuits);
}

std::vector<Miss> missesOf(std::span<ConditionMiss const> children, World const& world,
                           CircuitSight& circuits) {
    std::vector<Miss> misses;
    misses.reserve(children.size());
    for (std::size_t i = 0; i < children.size(); ++i) {
        misses.push_back(children[i].now(world, circuits));
        if (misses.back().child == Miss::noChild) {
            misses.back().child = i;
        }
    }
    return misses;
}

Miss missOfAll(ConditionMiss const& one, World const& world, CircuitSight& circuits) {
    std::vector<Miss> misses = missesOf(one.children(), world, circuits);
    double sum = 0;
    Miss const* worst = nullptr;
    for (std::size_t i = 0; i < misses.size(); ++i) {
        sum += misses[i].measure;
        misses[i].child = i;
        if (worst == nullptr || misses[i].measure > worst->measure) {
            worst = &misses[i];
        }
    }
    if (worst == nullptr) {
        return met();
    }
    Miss made = *worst;
    made.measure = sum / static_cast<double>(misses.size());
    return made;
}

Miss missOfAny(ConditionMiss const& one, World const& world, CircuitSight& circuits) {
    std::vector<Miss> const misses = missesOf(one.children(), world, circuits);
    Miss best;
    for (std::size_t i = 0; i < misses.size(); ++i) {
        keepNearer(best, misses[i]);
        if (best.measure == misses[i].measure && best.child == Miss::noChild) {
            best.child = i;
        }
    }
    return best;
}

Miss missOfCount(ConditionMiss const& one, World const& world, CircuitSight& circuits) {
    conditions::WantedCount const wanted = conditions::wantedCount(one.state().condition());
    int const number =
        static_cast<int>(std::count_if(one.children().begin(), one.children().end(),
                                       [](ConditionMiss const& child) { return child.state().met(); }));
    if (number > wanted.most) { // too many
        Miss made = otherWayRound(one.state());
        made.lack = Lack::count;
        made.tooMany = true;
        made.by = number - wanted.most;
        made.measure = made.by / (made.by + 1);
        return made;
    }
    std::vector<Miss> misses = missesOf(one.children(), world, circuits);
    std::stable_sort(misses.begin(), misses.end(),
                     [](Miss const& a, Miss const& b) { return a.measure < b.measure; });
    std::size_t const needed = std::min(static_cast<std::size_t>(std::max(0, wanted.least)), misses.size());
    double sum = 0;
    for (std::size_t i = 0; i < needed; ++i) {
        sum += misses[i].measure;
    }
    Miss made = otherWayRound(one.state());
    if (needed > 0) { // the lack of the next object says more than the missing number
        Miss const& next = misses[std::min(static_cast<std::size_t>(number), misses.size() - 1)];
        made.besides.push_back(next);
        made.measure = sum / static_cast<double>(needed);
    }
    made.lack = Lack::count;
    made.by = wanted.least - number;
    return made;
}

Miss missOfSequence(ConditionMiss const& one, World const& world, CircuitSight& circuits) {
    std::size_t const done = conditions::stepsDone(one.state());
    std::size_t const all = one.children().size();
    if (done >= all) {
        return met();
    }
    Miss made = one.children()[done].now(world, circuits);
    if (made.measure <= 0) { // it held before its turn came
        made = otherWayRound(one.children()[done].state());
    }
    made.child = done;
    made.measure = (static_cast<double>(all - done - 1) + made.measure) / static_cast<double>(all);
    return made;
}

struct KindOfMiss {
    std::string_view key;
    Miss (*miss)(ConditionMiss const&, World const&, CircuitSight&);
};
constexpr std::array<KindOfMiss, 10> kinds{{{"inside", missOfInside},
                                            {"touching", missOfTouching},
                                            {"on", missOfCurrent},
                                            {"off", missOfNoCurrent},
                                            {"moved", missOfMoved},
                                            {"count", missOfCount},
                                            {"all", missOfAll},
                                            {"any", missOfAny},
                                            {"not", missOfNegation},
                                            {"sequence", missOfSequence}}};

} // namespace

ConditionMiss::ConditionMiss(ConditionState const& state, World const& world) : state_(state) {
    for (ObjectId const id : state.subjects()) {
        Position const* const position = world.find<Position>(id);
        starts_.push_back(position == nullptr ? Vec2{} : position->value);
    }
    for (ConditionState const& child : state.children()) {
        children_.emplace_back(child, world);
    }
}

Miss ConditionMiss::now(World const& world, CircuitSight& circuits) const {
    if (state_.met()) {
        return met();
    }
    std::optional<double> const seconds = state_.condition().seconds;
    bool const timed = seconds && *seconds > frameDuration;
    if (state_.holds() && timed) {
        Miss miss = otherWayRound(state_);
        miss.lack = Lack::time;
        miss.by = *seconds * (1 - state_.progress());
        miss.measure = shareOfTime * std::clamp(1 - state_.progress(), 0.0, 1.0);
        return miss;
    }
    std::string_view const key = state_.condition().kind->key();
    auto const kind = std::find_if(kinds.begin(), kinds.end(), [&](auto const& k) { return k.key == key; });
    Miss miss = kind == kinds.end() ? otherWayRound(state_) : kind->miss(*this, world, circuits);
    // A condition that does not hold is not met, even if its numbers show no distance.
    miss.measure = std::clamp(miss.measure, std::numeric_limits<double>::epsilon(), 1.0);
    if (timed) {
        miss.measure = shareOfTime + (1 - shareOfTime) * miss.measure;
    }
    return miss;
}

std::vector<std::string_view> measurableKinds() {
    std::vector<std::string_view> keys;
    for (KindOfMiss const& kind : kinds) {
        keys.push_back(kind.key);
    }
    return keys;
}

} // namespace trembler::insight
