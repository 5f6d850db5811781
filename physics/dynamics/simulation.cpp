#include "physics/dynamics/simulation.hpp"

#include "physics/dynamics/solver_demand.hpp"
#include "runtime/component/component.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

// Semi-implicit Euler needs ω dt < 2. Twice as fine also keeps a zig-zag from swinging visibly; welds that an
// engine solves one by one, and turns back by the hold of one point, need more. Measured: docs/stability.md.
constexpr double tautMargin = 2;
constexpr double weldMargin = 6;
// What rests on a body, as a multiple r of its mass: 0.9 √r substeps hold stacks of equals.
// Something heavy on something light takes more rounds as well, half of r, between these two.
constexpr double stackFactor = 0.9;
constexpr double heaviest = 32;
constexpr int mostRounds = 64;
// Joints in one piece that an engine can still solve one by one, in the iterations of a few substeps.
constexpr std::size_t largestOneByOne = 24;
// Joints that are new carry nothing yet, and where they are solved one by one, what hangs on them would fall,
// stretch them and swing for ever after. So, where much hangs on them, the frame in which they are made and
// the next, in which forces first act on what has just been made, look for what they carry with many more
// iterations.
constexpr int settlingFrames = 2;
constexpr int settlingSubsteps = 64;
constexpr int settlingIterations = 256;
// Box2D lets nothing move by more than 2 of its units, or turn by more than a quarter, in one step.
constexpr double farthestPerStep = 1.9;
constexpr double widestPerStep = 1.5;
constexpr int leastSubsteps = 4;
// But where masses fly freely about each other, a step is a frame: as long as the forces that depend on their
// places stand. Split up, it would let these lag behind, and the energy of an orbit grow without end.

} // namespace

// The unit of an automatic scale is chosen for the first bodies that move, and kept as long as any do: a new
// unit is a new engine, which knows nothing of the old one's contacts.
double Simulation::scaleNow(DynamicsSettings const& settings, DynamicsColumns const& columns) const {
    if (settings.scale != DynamicsSettings::automatic) {
        return settings.scale;
    }
    auto const moves = [](Body const& body) { return body.object.valid() && !body.fixed; };
    bool const keep = engine_ && settings_.scale == DynamicsSettings::automatic &&
                      (columns.bodiesVersion() == bodiesVersion_ ||
                       std::any_of(bodies_.bodies().begin(), bodies_.bodies().end(), moves));
    return keep ? engineScale_ : scaleFor(columns);
}

void Simulation::makeEngine(DynamicsSettings const& settings, DynamicsColumns const& columns) {
    double const scale = scaleNow(settings, columns);
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
    contactRounds_ = 0;
}

void Simulation::noteDemand(double gravity, DynamicsColumns const& columns) {
    double const before = jointSubsteps_;
    double const halfFrame = frameDuration / 2;
    JointDemand const demand = jointDemand(columns, bodies_, joints_, gravity);
    double const taut = tautMargin * demand.zigZag * halfFrame;
    double const bending = weldMargin * demand.bending * halfFrame;
    bool const atOnce = std::max(taut, bending) > leastSubsteps || demand.network > largestOneByOne;
    choice_.jointsAtOnce = engine_->solveJointsAtOnce(atOnce);
    jointSubsteps_ = choice_.jointsAtOnce ? taut : std::max(taut, bending);
    if (!choice_.jointsAtOnce && jointSubsteps_ > leastSubsteps && jointSubsteps_ > before) {
        settling_ = settlingFrames;
    }
}

void Simulation::forgetDemand() {
    jointSubsteps_ = contactSubsteps_ = 0;
    contactRounds_ = settling_ = 0;
    demandGravity_ = -1;
    choice_.jointsAtOnce = engine_->solveJointsAtOnce(false);
}

std::vector<Refusal> Simulation::follow(DynamicsColumns const& columns) {
    DynamicsSettings const settings = columns.worldSettings();
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
    if (settings.substeps != DynamicsSettings::automatic) {
        forgetDemand();
    } else if (double const gravity = length(columns.gravity()); jointsChanged || gravity != demandGravity_) {
        demandGravity_ = gravity;
        noteDemand(gravity, columns);
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
        double const ratio = loadRatio(columns, bodies_, touching, columns.gravity());
        contactSubsteps_ = stackFactor * std::sqrt(ratio);
        contactRounds_ = ratio > heaviest ? static_cast<int>(std::min<double>(mostRounds, ratio / 2)) : 0;
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
        bool const orbits = !touching_.any() && joints_.joints().empty() && !columns.gravityLaw.empty();
        double const least = orbits ? 1 : leastSubsteps;
        chosen.substeps = roundedSubsteps(std::max({least, jointSubsteps_, contactSubsteps_, motion}));
        chosen.velocityIterations = std::max(chosen.velocityIterations, contactRounds_);
        if (settling_ > 0) {
            --settling_;
            chosen.substeps = settlingSubsteps;
            chosen.velocityIterations = std::max(chosen.velocityIterations, settlingIterations);
        }
    }
    choice_.substeps = chosen.substeps;
    choice_.velocityIterations = chosen.velocityIterations;
    choice_.scale = chosen.scale;
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
