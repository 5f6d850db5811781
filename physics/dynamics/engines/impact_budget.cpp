#include "physics/dynamics/engines/impact_budget.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace trembler {
namespace {

/// The greatest impulse (N s) from a motion of that energy (J): the one that reverses it.
double greatestImpulse(double energy, double inverse) {
    return std::sqrt(8 * energy / inverse);
}

} // namespace

double kineticEnergy(double mass, double inertia, Vec2 velocity, double spin) {
    return 0.5 * (mass * lengthSquared(velocity) + inertia * spin * spin);
}

void ImpactBudget::add(Impact const& impact, SlotIndex slot, Body const& a, Body const& b) {
    Candidate candidate{.impact = impact, .slot = slot};
    candidate.lightness = a.inverseMass + b.inverseMass;
    for (Body const* const body : {&a, &b}) {
        double const arm = cross(impact.point - body->centre, impact.normal);
        candidate.inverse += body->inverseMass + arm * arm * body->inverseInertia;
    }
    double const speed = dot(a.velocityAt(impact.point) - b.velocityAt(impact.point), impact.normal);
    if (!(candidate.inverse > 0)) {
        return; // two fixed bodies
    }
    candidate.approach = speed > 0 ? speed * speed / (2 * candidate.inverse) : 0;
    candidates_.push_back(candidate);
}

bool ImpactBudget::exceeded() const {
    return std::any_of(candidates_.begin(), candidates_.end(), [](Candidate const& one) {
        return one.impact.impulse > greatestImpulse(one.approach, one.inverse);
    });
}

void ImpactBudget::reset(std::size_t slots) {
    parents_.resize(slots);
    std::iota(parents_.begin(), parents_.end(), SlotIndex{0});
    lost_.assign(slots, 0);
    approach_.assign(slots, 0);
}

SlotIndex ImpactBudget::rootOf(SlotIndex slot) {
    while (parents_[slot] != slot) {
        parents_[slot] = parents_[parents_[slot]];
        slot = parents_[slot];
    }
    return slot;
}

// The lower slot becomes the root, so that the result does not depend on the order of the links; energies are
// summed by slot.
void ImpactBudget::link(SlotIndex a, SlotIndex b) {
    a = rootOf(a);
    b = rootOf(b);
    parents_[std::max(a, b)] = std::min(a, b);
}

void ImpactBudget::lose(SlotIndex slot, double energy) {
    lost_[slot] = std::max(0.0, energy);
}

void ImpactBudget::settle(std::vector<Impact>& impacts) {
    bool const connected = exceeded();
    if (connected) {
        for (SlotIndex slot = 0; slot < lost_.size(); ++slot) {
            if (SlotIndex const root = rootOf(slot); root != slot) {
                lost_[root] += lost_[slot];
            }
        }
        for (Candidate const& one : candidates_) {
            approach_[rootOf(one.slot)] += one.approach;
        }
    }
    for (Candidate const& one : candidates_) {
        double energy = one.approach;
        if (connected) {
            SlotIndex const root = rootOf(one.slot);
            energy = std::max({energy, lost_[root], approach_[root]});
        }
        append(one, energy, impacts);
    }
}

void ImpactBudget::settleGroup(double had, double lost, std::vector<Impact>& impacts) {
    double shared = 0;
    if (exceeded()) {
        for (Candidate const& one : candidates_) {
            shared += one.approach;
        }
        shared = std::max(std::min(shared, had), lost); // one body's approaches to several others add up
    }
    for (Candidate const& one : candidates_) {
        append(one, std::max(one.approach, shared), impacts);
    }
}

void ImpactBudget::append(Candidate const& one, double energy, std::vector<Impact>& impacts) {
    Impact impact = one.impact;
    impact.impulse = std::min(impact.impulse, greatestImpulse(energy, one.inverse));
    if (impact.impulse * one.lightness > faintestImpact) {
        impacts.push_back(impact);
    }
}

} // namespace trembler
