#include "physics/dynamics/core/demand/load_ratio.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

// Least share of the forces on a body along one direction for it to count as pressed. A floating body has
// equal forces up and down. A body that is pressed at all is pressed by at least this share along one of four
// directions.
constexpr double leastPress = 0.3;

struct Rest {
    double height = 0;  // m
    double carried = 0; // kg
    int supports = 0;
    bool pressed = false;
};
struct Support {
    SlotIndex upper;
    SlotIndex lower; // noSlot: the ground
};

// The axis along which most of the forces on movable bodies act: the greater principal axis of their squares.
// None without forces.
Vec2 axisOf(BodyTable const& bodies, std::span<LoadSum const> loads) {
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (SlotIndex slot = 0; slot < loads.size(); ++slot) {
        if (bodies.moves(slot)) {
            Vec2 const force = loads[slot].load.force;
            xx += force.x * force.x;
            xy += force.x * force.y;
            yy += force.y * force.y;
        }
    }
    double const half = (xx - yy) / 2;
    double const radius = std::hypot(half, xy);
    Vec2 const along = half > 0 ? Vec2{half + radius, xy} : Vec2{xy, radius - half};
    double const size = length(along);
    return size > 0 ? along / size : Vec2{0, yy > 0 ? 1.0 : 0.0};
}

// The contacts as supports, from the top downwards.
std::vector<Support> supportsOf(BodyTable const& bodies, std::span<TouchingPair const> touching,
                                std::vector<Rest>& rests) {
    std::vector<Support> supports;
    for (TouchingPair const& pair : touching) {
        SlotIndex a = bodies.slotOf(pair.a);
        SlotIndex b = bodies.slotOf(pair.b);
        if (!bodies.moves(a)) {
            std::swap(a, b);
        }
        if (!bodies.moves(a)) {
            continue;
        }
        if (!bodies.moves(b)) {
            supports.push_back({a, noSlot});
        } else if (rests[a].height > rests[b].height) {
            supports.push_back({a, b});
        } else if (rests[b].height > rests[a].height) {
            supports.push_back({b, a});
        }
    }
    for (Support const& support : supports) {
        ++rests[support.upper].supports;
    }
    std::stable_sort(supports.begin(), supports.end(), [&](Support const& x, Support const& y) {
        return rests[x.upper].height > rests[y.upper].height;
    });
    return supports;
}

// The greatest ratio of the mass that rests on a body to its own, `up` (a unit vector) being up.
double loadRatioUnder(Vec2 up, DynamicsColumns const& columns, BodyTable const& bodies,
                      std::span<TouchingPair const> touching, std::span<LoadSum const> loads) {
    std::vector<Rest> rests(bodies.bodies().size());
    bool any = false;
    for (SlotIndex slot = 0; slot < rests.size() && slot < loads.size(); ++slot) {
        double const press = -dot(loads[slot].load.force, up);
        rests[slot].pressed = bodies.moves(slot) && press > leastPress * loads[slot].gross;
        any = any || rests[slot].pressed;
    }
    if (!any) {
        return 0;
    }
    for (SlotIndex slot = 0; slot < rests.size(); ++slot) {
        if (bodies.moves(slot)) {
            Body const& body = bodies[slot];
            rests[slot].height =
                dot(up, worldCentre(body, columns.position.values()[body.rows.position].value,
                                    columns.rotation.values()[body.rows.rotation].angle));
        }
    }
    double most = 0;
    for (Support const& support : supportsOf(bodies, touching, rests)) {
        if (support.lower == noSlot) {
            continue;
        }
        Rest const& upper = rests[support.upper];
        Rest& lower = rests[support.lower];
        double const own = upper.pressed ? bodies[support.upper].mass : 0;
        lower.carried += (own + upper.carried) / upper.supports;
        most = std::max(most, lower.carried / bodies[support.lower].mass);
    }
    return most;
}

} // namespace

double loadRatio(DynamicsColumns const& columns, BodyTable const& bodies,
                 std::span<TouchingPair const> touching, std::span<LoadSum const> loads) {
    Vec2 const axis = touching.empty() ? Vec2{} : axisOf(bodies, loads);
    double most = 0;
    if (!(axis == Vec2{})) {
        Vec2 const across = perpendicular(axis);
        for (Vec2 const up : {axis, -1 * axis, across, -1 * across}) {
            most = std::max(most, loadRatioUnder(up, columns, bodies, touching, loads));
        }
    }
    return most;
}

} // namespace trembler
