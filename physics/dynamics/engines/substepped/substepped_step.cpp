// A step of an engine around a library: its substeps and their results.
#include "physics/dynamics/engines/substepped/substepped_engine.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {

void SubsteppedEngine::step(double duration, DynamicsSettings const& settings) {
    FailureGuard const guard;
    if (!settings.sleeping) {
        for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
            wake(slot);
        }
    }
    std::fill(movedMarks_.begin(), movedMarks_.end(), std::uint8_t{0});
    for (JointEntry& entry : joints_) {
        entry.force = {};
    }
    touches_.startStep();
    double const h = duration / settings.substeps;
    for (int i = 0; i < settings.substeps; ++i) {
        noteVelocities();
        substep(h, settings);
        findImpacts(h * i);
    }
    lookAtFast(h);
    if (settings.sleeping) {
        findRest(duration);
    }
    noteMoved();
}

void SubsteppedEngine::noteVelocities() {
    if (touches_.impactsWanted()) {
        atStart_.resize(bodies_.size());
        for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
            atStart_[slot] = moves(slot) ? motionOf(slot) : Motion{};
        }
    }
}

void SubsteppedEngine::findImpacts(double since) {
    if (!touches_.impactsWanted()) {
        return;
    }
    TouchRecord::ImpactScene scene;
    scene.slots = bodies_.size();
    scene.before = [this](SlotIndex slot) {
        if (!moves(slot)) {
            return ImpactBudget::Body{};
        }
        Motion const& motion = atStart_[slot];
        return ImpactBudget::Body{1 / bodies_[slot].mass, 1 / bodies_[slot].inertia, motion.centre,
                                  motion.velocity, motion.spin};
    };
    scene.lost = [this](SlotIndex slot) {
        auto const energy = [&](Motion const& motion) {
            return kineticEnergy(bodies_[slot].mass, bodies_[slot].inertia, motion.velocity, motion.spin);
        };
        return energy(atStart_[slot]) - energy(motionOf(slot));
    };
    for (JointEntry const& joint : joints_) {
        if (joint.used) {
            scene.joined.emplace_back(joint.a, joint.b);
        }
    }
    touches_.findImpacts(since, scene);
}

void SubsteppedEngine::substep(double h, DynamicsSettings const& settings) {
    move(h, settings, found_);
    checkMotion();
    // A contact wakes both bodies; the contacts that were not found again have both bodies asleep.
    for (PieceContact const& contact : found_) {
        rouseSleeper(contact.slotA);
        rouseSleeper(contact.slotB);
    }
    touches_.take(found_, [this](PieceContact const& contact) {
        return awake_[contact.slotA] == 0 && awake_[contact.slotB] == 0;
    });
    for (std::size_t slot = 0; slot < bodies_.size(); ++slot) {
        movedMarks_[slot] |= awake_[slot];
        if (awake_[slot] != 0 && slot < dragged_.size() && dragged_[slot].drag.any()) {
            dragged_[slot].after(momentumOf(static_cast<SlotIndex>(slot)));
        }
    }
    for (SlotIndex slot = 0; slot < joints_.size(); ++slot) {
        JointEntry& entry = joints_[slot];
        if (entry.used && ((moves(entry.a) && isAwake(entry.a)) || (moves(entry.b) && isAwake(entry.b)))) {
            entry.force += jointImpulse(slot) / (h * settings.substeps);
        }
    }
}

// A substep finds the contacts at the positions at its beginning. Fast bodies have moved since: a touching
// pair may have separated, and a body may have penetrated another one, but the world reads the state at the
// frame's end.
void SubsteppedEngine::lookAtFast(double h) {
    std::vector<SlotIndex> fast;
    for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
        if (awake_[slot] != 0) {
            Motion const motion = motionOf(slot);
            if (h * (length(motion.velocity) + std::abs(motion.spin) * bodies_[slot].extent) > farInSubstep) {
                fast.push_back(slot);
            }
        }
    }
    if (fast.empty() || !lookAgain(fast, found_)) {
        return;
    }
    std::span<PieceContact const> const known = touches_.contacts();
    // Known contacts keep the impulses from the positions at which they were solved.
    for (PieceContact& contact : found_) {
        auto const at =
            std::lower_bound(known.begin(), known.end(), contact.key,
                             [](PieceContact const& x, std::uint64_t key) { return x.key < key; });
        if (at != known.end() && at->key == contact.key && at->patch.count == contact.patch.count) {
            contact.patch.normalImpulse = at->patch.normalImpulse;
            contact.patch.tangentImpulse = at->patch.tangentImpulse;
        }
    }
    auto const isFast = [&](SlotIndex slot) { return std::binary_search(fast.begin(), fast.end(), slot); };
    touches_.take(found_, [&](PieceContact const& contact) {
        return !isFast(contact.slotA) && !isFast(contact.slotB);
    });
}

// The library does not check its results.
void SubsteppedEngine::checkMotion() const {
    for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
        if (awake_[slot] != 0) {
            Motion const motion = motionOf(slot);
            if (!isFinite(motion.centre) || !isFinite(motion.velocity) || !std::isfinite(motion.angle) ||
                !std::isfinite(motion.spin)) {
                throw EngineFailure("a body's place or speed is no finite number");
            }
        }
    }
}

} // namespace trembler
