// Islands of touching or joined bodies fall asleep, and wake, together.
#include "physics/dynamics/engines/sleep_limits.hpp"
#include "physics/dynamics/engines/substepped/substepped_engine.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace trembler {

void SubsteppedEngine::noteAwake(SlotIndex slot) {
    awake_[slot] = 1;
    bodies_[slot].idle = 0;
    anyAwake_ = true;
}

void SubsteppedEngine::wake(SlotIndex slot) {
    if (!moves(slot)) {
        return;
    }
    bodies_[slot].idle = 0;
    if (awake_[slot] != 0) {
        return;
    }
    std::vector<SlotIndex> const& roots = islands();
    SlotIndex const root = roots[slot];
    for (SlotIndex other = 0; other < bodies_.size(); ++other) {
        if (roots[other] == root && moves(other) && awake_[other] == 0) {
            rouse(other);
            noteAwake(other);
        }
    }
}

std::vector<SlotIndex> const& SubsteppedEngine::islands() {
    roots_.resize(bodies_.size());
    std::iota(roots_.begin(), roots_.end(), SlotIndex{0});
    auto const rootOf = [this](SlotIndex slot) {
        while (roots_[slot] != slot) {
            slot = roots_[slot] = roots_[roots_[slot]];
        }
        return slot;
    };
    auto const link = [&](SlotIndex a, SlotIndex b) {
        if (moves(a) && moves(b)) {
            SlotIndex const x = rootOf(a);
            SlotIndex const y = rootOf(b);
            roots_[std::max(x, y)] = std::min(x, y);
        }
    };
    for (PieceContact const& contact : touches_.contacts()) {
        link(contact.slotA, contact.slotB);
    }
    for (JointEntry const& joint : joints_) {
        if (joint.used) {
            link(joint.a, joint.b);
        }
    }
    for (SlotIndex slot = 0; slot < roots_.size(); ++slot) {
        roots_[slot] = rootOf(slot);
    }
    return roots_;
}

bool SubsteppedEngine::idles(SlotIndex slot, Motion const& motion) const {
    BodyEntry const& entry = bodies_[slot];
    double const speed = length(motion.velocity);
    double const spin = std::abs(motion.spin);
    if (entry.restlessJoints > 0 || speed > slowSpeed || spin > slowSpin) {
        return false;
    }
    bool const free = entry.joints == 0 && touching_[slot] == 0;
    return !free || (length(entry.load.force) <= driftAcceleration * entry.mass && speed <= driftSpeed &&
                     spin <= driftSpin);
}

void SubsteppedEngine::findRest(double duration) {
    touching_.assign(bodies_.size(), 0);
    for (PieceContact const& contact : touches_.contacts()) {
        touching_[contact.slotA] = touching_[contact.slotB] = 1;
    }
    bool anyTired = false;
    for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
        if (awake_[slot] != 0) {
            bool const idle = idles(slot, motionOf(slot));
            bodies_[slot].idle = idle ? bodies_[slot].idle + duration : 0;
            anyTired = anyTired || bodies_[slot].idle >= timeToSleep;
        }
    }
    if (!anyTired) {
        return;
    }
    std::vector<SlotIndex> const& roots = islands();
    std::vector<double> least(bodies_.size(), timeToSleep);
    for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
        if (awake_[slot] != 0) {
            least[roots[slot]] = std::min(least[roots[slot]], bodies_[slot].idle);
        }
    }
    // Root of the island and body, for each body that falls asleep.
    std::vector<std::pair<SlotIndex, SlotIndex>> resting;
    for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
        if (awake_[slot] != 0 && least[roots[slot]] >= timeToSleep) {
            resting.emplace_back(roots[slot], slot);
        }
    }
    std::sort(resting.begin(), resting.end());
    std::vector<SlotIndex> island;
    for (auto first = resting.begin(); first != resting.end();) {
        island.clear();
        for (SlotIndex const root = first->first; first != resting.end() && first->first == root; ++first) {
            SlotIndex const slot = first->second;
            Motion still = motionOf(slot);
            still.velocity = {};
            still.spin = 0;
            setMotion(slot, still);
            awake_[slot] = 0;
            island.push_back(slot);
        }
        layToRest(island);
    }
}

} // namespace trembler
