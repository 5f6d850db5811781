#include "insight/miss/negated_miss.hpp"

#include "insight/miss/area_distance.hpp"
#include "insight/miss/current/current_miss.hpp"
#include "insight/miss/current/ways_of_current.hpp"
#include "insight/miss/moved_ways.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "puzzle/goals/conditions/count.hpp"
#include "puzzle/goals/conditions/moved.hpp"
#include "puzzle/goals/conditions/touching.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <limits>

namespace trembler::insight {
namespace negated_miss {
namespace {

Miss unmeasured(ConditionState const& state) {
    Miss made;
    made.by = 1;
    made.objects = state.subjects();
    return made;
}

Miss nothingLacks() {
    Miss made;
    made.measure = 0;
    made.lack = Lack::nothing;
    return made;
}

/// Keeps the farther one: each of several objects must cease to meet the condition.
void keepFarther(Miss& worst, Miss const& other) {
    if (worst.objects.empty() || other.measure > worst.measure) {
        worst = other;
    }
}

Miss ofInside(ConditionMiss const& one, World const& world) {
    Area const& area = *one.state().condition().area;
    Miss worst;
    for (ObjectId const id : one.state().subjects()) {
        Position const* const position = world.find<Position>(id);
        if (position == nullptr || !area.contains(position->value)) {
            continue;
        }
        Miss miss;
        miss.lack = Lack::distance;
        miss.from = position->value;
        miss.to = nearestEdgeOf(area, position->value);
        miss.by = length(miss.to - miss.from);
        miss.measure = miss.by / (miss.by + typicalDistance);
        miss.objects = {id};
        keepFarther(worst, miss);
    }
    return worst.objects.empty() ? unmeasured(one.state()) : worst;
}

Miss ofMoved(ConditionMiss const& one, World const& world) {
    conditions::WantedMove const wanted = conditions::wantedMove(one.state().condition());
    Miss worst;
    bool const anyDirection = wanted.towards == Vec2{};
    for (MovedWay const& moved : movedWays(one, world)) {
        if (moved.done < wanted.distance) {
            continue;
        }
        double const far = length(moved.way);
        Vec2 const back = anyDirection ? (far > 0 ? moved.way * (-1 / far) : Vec2{}) : wanted.towards * -1.0;
        Miss miss;
        miss.lack = Lack::distance;
        miss.by = moved.done - wanted.distance;
        miss.from = moved.at;
        miss.to = moved.at + back * miss.by;
        miss.measure = miss.by / (miss.by + typicalDistance);
        miss.objects = {moved.object};
        keepFarther(worst, miss);
    }
    return worst.objects.empty() ? unmeasured(one.state()) : worst;
}

/// Every pair must part: the fewer still touch, the nearer. Within a pair there is nothing between touching
/// and not touching.
Miss ofTouching(ConditionMiss const& one, World const& world) {
    Contacts const* const contacts = world.find<Contacts>();
    Miss made = unmeasured(one.state());
    if (contacts == nullptr) {
        return made;
    }
    if (auto const touches = conditions::wantedTouches(one.state(), *contacts); !touches.empty()) {
        made.objects = {touches.front().first, touches.front().second};
        made.lack = Lack::touches;
        made.by = static_cast<double>(touches.size());
        made.measure = made.by / (made.by + 1);
    }
    return made;
}

Miss ofOn(ConditionMiss const& one, World const& world) {
    Miss worst;
    for (ObjectId const id : one.state().subjects()) {
        if (auto const ways = waysOfCurrent(world, id); !ways.empty()) {
            Miss miss;
            miss.lack = Lack::ways;
            miss.ways = ways;
            miss.by = static_cast<double>(ways.size());
            miss.measure = miss.by / (miss.by + 1);
            miss.objects = {id};
            keepFarther(worst, miss);
        }
    }
    return worst.objects.empty() ? unmeasured(one.state()) : worst;
}

Miss ofCount(ConditionMiss const& one) {
    conditions::WantedCount const wanted = conditions::wantedCount(one.state().condition());
    auto const number =
        static_cast<int>(std::count_if(one.children().begin(), one.children().end(),
                                       [](ConditionMiss const& child) { return child.state().met(); }));
    auto const all = static_cast<int>(one.children().size());
    int fewest = std::numeric_limits<int>::max();
    bool tooMany = true;
    if (wanted.least > 0) {
        fewest = number - wanted.least + 1;
    }
    if (wanted.most < all) {
        tooMany = fewest <= wanted.most - number + 1;
        fewest = std::min(fewest, wanted.most - number + 1);
    }
    Miss made = unmeasured(one.state());
    if (fewest < std::numeric_limits<int>::max()) {
        made.lack = Lack::count;
        made.tooMany = tooMany;
        made.by = fewest;
        made.measure = made.by / (made.by + 1);
    }
    return made;
}

/// Of several: the nearest one must cease to be met.
Miss ofAll(ConditionMiss const& one, World const& world, CircuitSight& circuits) {
    Miss best = unmeasured(one.state());
    for (std::size_t i = 0; i < one.children().size(); ++i) {
        Miss miss = negatedMiss(one.children()[i], world, circuits);
        if (i == 0 || miss.measure < best.measure) {
            best = std::move(miss);
        }
    }
    return best;
}

/// Each must.
Miss ofAny(ConditionMiss const& one, World const& world, CircuitSight& circuits) {
    Miss worst = unmeasured(one.state());
    double sum = 0;
    for (std::size_t i = 0; i < one.children().size(); ++i) {
        Miss miss = negatedMiss(one.children()[i], world, circuits);
        sum += miss.measure;
        if (i == 0 || miss.measure > worst.measure) {
            worst = std::move(miss);
        }
    }
    if (!one.children().empty()) {
        worst.measure = sum / static_cast<double>(one.children().size());
    }
    return worst;
}

} // namespace
} // namespace negated_miss

Miss negatedMiss(ConditionMiss const& one, World const& world, CircuitSight& circuits) {
    ConditionState const& state = one.state();
    if (!state.met()) {
        return negated_miss::nothingLacks();
    }
    std::string_view const key = state.condition().kind->key();
    Miss made = negated_miss::unmeasured(state);
    if (key == "inside") {
        made = negated_miss::ofInside(one, world);
    } else if (key == "moved") {
        made = negated_miss::ofMoved(one, world);
    } else if (key == "touching") {
        made = negated_miss::ofTouching(one, world);
    } else if (key == "on") {
        made = negated_miss::ofOn(one, world);
    } else if (key == "off") {
        made = missOfOn(state, world, circuits);
    } else if (key == "count") {
        made = negated_miss::ofCount(one);
    } else if (key == "all") {
        made = negated_miss::ofAll(one, world, circuits);
    } else if (key == "any") {
        made = negated_miss::ofAny(one, world, circuits);
    } else if (key == "not" && !one.children().empty()) {
        made = one.children().front().now(world, circuits);
    }
    made.measure = std::clamp(made.measure, std::numeric_limits<double>::epsilon(), 1.0);
    made.child = Miss::noChild;
    return made;
}

} // namespace trembler::insight
