#include "physics/dynamics/core/demand/solver_demand.hpp"

#include "physics/dynamics/core/demand/joint_graph.hpp"
#include "physics/dynamics/properties/shapes/shape_rules.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace trembler {
namespace {

// The point where a joint holds one of its bodies, from that body's centre of mass (m).
struct Hold {
    SlotIndex body = noSlot;
    Vec2 at;
    double pull = 0;   // N
    bool weld = false; // the body cannot turn about the point
};

double squareFrequency(Body const& body, std::span<Hold const> holds) {
    if (std::any_of(holds.begin(), holds.end(), [](Hold const& hold) { return hold.weld; })) {
        return 0;
    }
    double pull = 0;
    double reach = holds.size() == 1 ? length(holds.front().at) : 0;
    for (Hold const& hold : holds) {
        pull = std::max(pull, hold.pull);
    }
    // Approximation: the greatest distance of two holds is about that of the first hold and the farthest from
    // it.
    for (Hold const& hold : holds) {
        reach = std::max(reach, length(hold.at - holds.front().at));
    }
    return pull * reach / body.inertia;
}

double thicknessOf(ShapePiece const& piece) {
    switch (piece.form) {
    case ShapeForm::circle:
    case ShapeForm::capsule:
        return 2 * piece.radius;
    case ShapeForm::box:
        return std::min(piece.width, piece.height);
    case ShapeForm::polygon:
        break;
    }
    // A polygon's least width across one of its sides.
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < piece.corners.size(); ++i) {
        Vec2 const side = piece.corners[(i + 1) % piece.corners.size()] - piece.corners[i];
        double across = 0;
        for (Vec2 const corner : piece.corners) {
            across = std::max(across, cross(side, corner - piece.corners[i]) / length(side));
        }
        least = std::min(least, across);
    }
    return least;
}

double zigZagFrequency(BodyTable const& bodies, JointTable const& joints, std::span<JointLoad const> loads) {
    std::vector<Hold> holds;
    for (std::size_t slot = 0; slot < loads.size(); ++slot) {
        TiedJoint const& tied = joints.joints()[slot];
        if (loads[slot].mass <= 0) {
            continue;
        }
        double const pull = loads[slot].pull;
        bool const weld = tied.joint.form == JointForm::weld;
        if (bodies.moves(tied.a)) {
            holds.push_back({tied.a, tied.anchors.onA - bodies[tied.a].centre, pull, weld});
        }
        if (bodies.moves(tied.b)) {
            holds.push_back({tied.b, tied.anchors.onB - bodies[tied.b].centre, pull, weld});
        }
    }
    std::stable_sort(holds.begin(), holds.end(),
                     [](Hold const& x, Hold const& y) { return x.body < y.body; });
    double most = 0;
    for (auto first = holds.begin(); first != holds.end();) {
        auto const last =
            std::find_if(first, holds.end(), [&](Hold const& hold) { return hold.body != first->body; });
        most = std::max(most, squareFrequency(bodies[first->body], {first, last}));
        first = last;
    }
    return std::sqrt(most);
}

double bendingFrequency(DynamicsColumns const& columns, BodyTable const& bodies, JointTable const& joints,
                        std::span<JointLoad const> loads) {
    double most = 0;
    for (std::size_t slot = 0; slot < loads.size(); ++slot) {
        TiedJoint const& tied = joints.joints()[slot];
        JointLoad const& load = loads[slot];
        if (load.mass <= 0 || !load.alone || tied.joint.form != JointForm::weld) {
            continue;
        }
        ObjectId const a = bodies[tied.a].object; // a fixed body need not have a rotation
        double const angle = columns.rotation.has(a) ? columns.rotation.find(a)->angle : 0;
        Vec2 const at = columns.position.find(a)->value + rotated(tied.anchors.onA, angle);
        double const moment = load.pull * length(load.centre - at);
        for (SlotIndex const side : {tied.a, tied.b}) {
            if (bodies.moves(side)) {
                most = std::max(most, moment / bodies[side].inertia);
            }
        }
    }
    return std::sqrt(most);
}

std::size_t largestNetwork(BodyTable const& bodies, JointTable const& joints) {
    std::vector<SlotIndex> leader(bodies.bodies().size());
    std::iota(leader.begin(), leader.end(), SlotIndex{0});
    auto const find = [&](SlotIndex slot) {
        while (leader[slot] != slot) {
            slot = leader[slot] = leader[leader[slot]];
        }
        return slot;
    };
    auto const counts = [&](TiedJoint const& tied) {
        JointForm const form = tied.joint.form;
        return tied.object.valid() && (bodies.moves(tied.a) || bodies.moves(tied.b)) &&
               (form == JointForm::hinge || form == JointForm::weld || form == JointForm::distance);
    };
    for (TiedJoint const& tied : joints.joints()) {
        if (counts(tied) && bodies.moves(tied.a) && bodies.moves(tied.b)) {
            leader[find(tied.a)] = find(tied.b);
        }
    }
    std::vector<std::size_t> ties(leader.size(), 0);
    std::size_t most = 0;
    for (TiedJoint const& tied : joints.joints()) {
        if (counts(tied)) {
            std::size_t& count = ties[find(bodies.moves(tied.a) ? tied.a : tied.b)];
            most = std::max(most, ++count);
        }
    }
    return most;
}

} // namespace

JointDemand jointDemand(DynamicsColumns const& columns, BodyTable const& bodies, JointTable const& joints,
                        std::span<LoadSum const> loads) {
    if (joints.joints().empty()) {
        return {};
    }
    std::vector<JointLoad> const carried = jointLoads(columns, bodies, joints, loads);
    return {zigZagFrequency(bodies, joints, carried), bendingFrequency(columns, bodies, joints, carried),
            largestNetwork(bodies, joints)};
}

double scaleFor(DynamicsColumns const& columns) {
    std::vector<double> thicknesses;
    std::span<ObjectId const> const owners = columns.shape.owners();
    for (std::size_t row = 0; row < owners.size(); ++row) {
        Shape const& shape = columns.shape.values()[row];
        if (columns.fixed.has(owners[row]) || columns.liquid.has(owners[row]) || faultIn(shape)) {
            continue;
        }
        double least = std::numeric_limits<double>::infinity();
        for (ShapePiece const& piece : shape.pieces) {
            least = std::min(least, thicknessOf(piece));
        }
        thicknesses.push_back(least);
    }
    constexpr std::size_t many = 20;
    double const thick = thicknesses.size() < many ? 0.06 : 0.4;
    double scale = 4;
    if (!thicknesses.empty()) {
        auto const middle = thicknesses.begin() + static_cast<std::ptrdiff_t>(thicknesses.size() / 2);
        std::nth_element(thicknesses.begin(), middle, thicknesses.end());
        while (scale < 64 && *middle * scale < thick) {
            scale *= 2;
        }
    }
    return scale;
}

int roundedSubsteps(double wanted) {
    for (int const n : {1, 2, 4, 6, 8, 12, 16, 24, 32, 48}) {
        if (wanted <= n) {
            return n;
        }
    }
    return 64;
}

} // namespace trembler
