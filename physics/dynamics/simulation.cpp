#include "physics/dynamics/simulation.hpp"

#include "physics/dynamics/solver_demand.hpp"
#include "runtime/component/component.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

// Semi-implicit Euler needs ω dt < 2. Twice as fine also keeps what the solver leaves over in each substep
// from adding up to visible jitter; welds, which it turns back by the hold of one point, need more. Measured:
// docs/stability.md.
constexpr double tautMargin = 2;
constexpr double weldMargin = 6;
constexpr double loadFactor = 2;
// Joints that are new carry nothing yet, and what hangs on them would fall, stretch them and swing for ever
// after. So, where much hangs on them, the frame in which they are made and the next, in which forces first
// act on what has just been made, look for what they carry with many more iterations.
constexpr int settlingFrames = 2;
constexpr int settlingSubsteps = 64;
constexpr int settlingIterations = 256;
// Box2D lets nothing move by more than 2 of its units, or turn by more than a quarter, in one step.
constexpr double farthestPerStep = 1.9;
constexpr double widestPerStep = 1.5;
constexpr int leastSubsteps = 4;

} // namespace

void Simulation::makeEngine(DynamicsSettings const& settings, DynamicsColumns const& columns) {
    // The unit of an automatic scale is chosen for the bodies that are there at first, and kept: a new unit
    // is a new engine, which knows nothing of the old one's contacts.
    double const scale = settings.scale != DynamicsSettings::automatic ? settings.scale
                         : engineScale_ > 0 && settings_.scale == DynamicsSettings::automatic
                             ? engineScale_
                             : scaleFor(columns);
    if (engine_ && scale == engineScale_) {
        return;
    }
    engineScale_ = scale;
    engine_ = maker_(scale);
    bodies_ = {};
    joints_ = {};
    touching_ = {};
    bodiesVersion_ = 0;
    contactSubsteps_ = 0;
}

void Simulation::noteDemand(DynamicsColumns const& columns, bool jointsChanged) {
    if (settings_.substeps != DynamicsSettings::automatic) {
        jointSubsteps_ = contactSubsteps_ = 0;
        settling_ = 0;
        return;
    }
    double const before = jointSubsteps_;
    double const gravity = length(columns.gravity());
    double const halfFrame = frameDuration / 2;
    jointSubsteps_ = std::max(tautMargin * zigZagFrequency(columns, bodies_, joints_, gravity) * halfFrame,
                              weldMargin * bendingFrequency(columns, bodies_, joints_, gravity) * halfFrame);
    if (jointSubsteps_ > leastSubsteps && (jointsChanged || before <= leastSubsteps)) {
        settling_ = settlingFrames;
    }
}

std::vector<Refusal> Simulation::follow(DynamicsColumns const& columns) {
    DynamicsSettings const settings = columns.worldSettings();
    bool const automaticNow =
        settings.substeps == DynamicsSettings::automatic && settings_.substeps != DynamicsSettings::automatic;
    makeEngine(settings, columns);
    settings_ = settings;
    std::vector<Refusal> refusals;
    bool const bodiesChanged =
        columns.bodiesVersion() != bodiesVersion_ || columns.motionStructure() != motionStructure_;
    bool const jointsChanged = bodiesChanged || columns.jointsVersion() != jointsVersion_;
    if (jointsChanged) {
        std::vector<SlotIndex> const going =
            bodiesChanged ? bodies_.outdated(columns) : std::vector<SlotIndex>{};
        joints_.removeOutdated(columns, going, *engine_);
        for (SlotIndex const slot : going) {
            bodies_.remove(slot, *engine_);
            causes_.forget(slot);
        }
        if (bodiesChanged) {
            bodies_.addMissing(columns, *engine_, refusals);
            bodies_.findRows(columns);
            loadsStale_ = true;
        }
        joints_.addMissing(columns, bodies_, *engine_, refusals);
        bodiesVersion_ = columns.bodiesVersion();
        jointsVersion_ = columns.jointsVersion();
        motionStructure_ = columns.motionStructure();
    }
    if (jointsChanged || automaticNow || settings.substeps != DynamicsSettings::automatic) {
        noteDemand(columns, jointsChanged);
    }
    if (columns.motionVersion() != motionVersion_) {
        bodies_.followMotion(columns, *engine_);
        motionVersion_ = columns.motionVersion();
    }
    return refusals;
}

void Simulation::endLoads() {
    loads_.apply(bodies_.bodies(), *engine_);
    loadsStale_ = false;
}

void Simulation::noteContacts(DynamicsColumns const& columns, std::span<TouchingPair const> touching) {
    if (settings_.substeps == DynamicsSettings::automatic) {
        contactSubsteps_ = loadFactor * std::sqrt(loadRatio(columns, bodies_, touching, columns.gravity()));
    }
}

DynamicsSettings Simulation::chosen(double duration, DynamicsColumns const& columns) {
    DynamicsSettings chosen = settings_;
    chosen.scale = engineScale_;
    if (settings_.substeps == DynamicsSettings::automatic) {
        double fastest = 0;
        for (Velocity const& velocity : columns.velocity.values()) {
            fastest = std::max(fastest, std::abs(velocity.value.x) + std::abs(velocity.value.y));
        }
        double spin = 0;
        for (AngularVelocity const& turning : columns.spin.values()) {
            spin = std::max(spin, std::abs(turning.value));
        }
        double const motion =
            duration * std::max(fastest * engineScale_ / farthestPerStep, spin / widestPerStep);
        chosen.substeps = roundedSubsteps(std::max({jointSubsteps_, contactSubsteps_, motion}));
        if (settling_ > 0) {
            --settling_;
            chosen.substeps = settlingSubsteps;
            chosen.velocityIterations = std::max(chosen.velocityIterations, settlingIterations);
        }
    }
    choice_ = {chosen.substeps, chosen.velocityIterations, chosen.scale};
    return chosen;
}

bool Simulation::step(double duration, DynamicsColumns const& columns) {
    if (!engine_->anyAwake()) {
        return false;
    }
    engine_->step(duration, chosen(duration, columns));
    loads_.noteSleepers(*engine_);
    return true;
}

} // namespace trembler
