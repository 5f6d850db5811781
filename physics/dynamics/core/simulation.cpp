#include "physics/dynamics/core/simulation.hpp"

#include "physics/dynamics/core/demand/load_ratio.hpp"
#include "physics/dynamics/core/demand/solver_demand.hpp"
#include "runtime/component/component.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

// Semi-implicit Euler needs ω dt < 2. Half of this step also prevents a visible zig-zag; welds that an engine
// solves one by one, and holds at a single point, need smaller steps. Measured:
// docs/measurements/stability.md.
constexpr double tautMargin = 2;
constexpr double weldMargin = 6;
// With r the mass that rests on a body as a multiple of its own, 0.9 √r substeps suffice for stacks of equal
// bodies. A heavy body on a light one also needs more iterations, half of r, between these two limits.
constexpr double stackFactor = 0.9;
constexpr double heaviest = 32;
constexpr int mostRounds = 64;
// The greatest number of connected joints that an engine can solve one by one in the iterations of a few
// substeps.
constexpr std::size_t largestOneByOne = 24;
// New joints carry no load yet. If they are solved one by one, bodies that hang on them would fall, stretch
// them and never stop swinging. So, if they carry much, their loads are computed with many more iterations in
// the frame in which they are created and in the next one, in which forces first act on the new bodies.
constexpr int settlingFrames = 2;
constexpr int settlingSubsteps = 64;
constexpr int settlingIterations = 256;
// Box2D limits the motion of a body in one step to 2 of its units and a quarter of a turn.
constexpr double farthestPerStep = 1.9;
constexpr double widestPerStep = 1.5;
constexpr int leastSubsteps = 4;
// But if all bodies fly freely, under varying forces that do not look ahead, a step is a frame. Split into
// substeps, the forces would lag, and the energy of an orbit would grow without bound. With a force that
// looks ahead, a body's energy ripples by about half of the angle, in rad, by which it swings in a step, as
// the semi-implicit Euler method has velocities half a step ahead of places.
constexpr double swingPerStep = 0.18;
// If many bodies fall together under such forces, impacts add too much energy; six substeps instead of four
// keep it small, more do not help.
constexpr std::size_t manyBodies = 20;
constexpr double swingPerStepOfMany = 0.06;
constexpr double substepsOfMany = 6;
// After this many failures in one frame all bodies are held still.
constexpr int mostFailures = 4;

// Stated and automatic numbers of substeps are those of a frame: a part of a frame has its share of them. If
// Dynamics has a period, the frames that it computes at once have together as many as one frame.
double shareOf(double duration) {
    return std::min(1.0, duration / frameDuration);
}

} // namespace

// The unit of an automatic scale is chosen for the first movable bodies, and kept while there are any: a new
// unit needs a new engine, without the old one's contacts.
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
    bodies_.standStill(state_.stopped);
    joints_ = {};
    causes_ = {}; // by slots, which other bodies may get
    touching_ = {};
    bodiesVersion_ = 0;
    contactSubsteps_ = 0;
    contactRounds_ = 0;
    jointsNew_ = contactsNew_ = true;
}

void Simulation::noteRate(StateRate const& call) {
    SlotIndex const slot = bodies_.slotOf(call.object);
    if (!bodies_.moves(slot) || !std::isfinite(call.rate)) {
        return;
    }
    if (call.swings && !call.foreseen) {
        loads_.noteVarying(slot);
    }
    if (call.rate > rates_.greatest) {
        rates_.greatest = call.rate;
        rates_.object = call.object;
    }
    if (!call.foreseen) {
        rates_.unforeseen = std::max(rates_.unforeseen, call.rate);
    }
    if (call.swings) {
        rates_.swinging = std::max(rates_.swinging, call.rate);
    }
    if (call.swings && call.foreseen) {
        rates_.ahead = std::max(rates_.ahead, call.rate);
    }
}

void Simulation::findJointDemand(double duration, DynamicsColumns const& columns) {
    double const before = jointSubsteps_;
    double const half = duration / 2;
    JointDemand const demand = jointDemand(columns, bodies_, joints_, loads_.sums());
    double const taut = tautMargin * demand.zigZag * half;
    double const bending = weldMargin * demand.bending * half;
    double const few = leastSubsteps * shareOf(duration);
    bool const atOnce = std::max(taut, bending) > few || demand.network > largestOneByOne;
    choice_.jointsAtOnce = engine_->solveJointsAtOnce(atOnce);
    jointSubsteps_ = choice_.jointsAtOnce ? taut : std::max(taut, bending);
    bool const more = settles_ || jointSubsteps_ > before;
    settles_ = more && !choice_.jointsAtOnce && jointSubsteps_ > few;
    jointsNew_ = false;
    demandFor_ = duration;
}

void Simulation::findContactDemand(DynamicsColumns const& columns, std::span<TouchingPair const> touching) {
    double const ratio = loadRatio(columns, bodies_, touching, loads_.sums());
    contactSubsteps_ = stackFactor * std::sqrt(ratio);
    contactRounds_ = ratio > heaviest ? static_cast<int>(std::min<double>(mostRounds, ratio / 2)) : 0;
    contactsNew_ = false;
}

void Simulation::forgetDemand() {
    jointSubsteps_ = contactSubsteps_ = 0;
    contactRounds_ = settling_ = 0;
    settles_ = false;
    jointsNew_ = contactsNew_ = true;
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
        jointsNew_ = true;
        settling_ = settlingFrames;
        settles_ = false;
    }
    if (settings.substeps != DynamicsSettings::automatic) {
        forgetDemand();
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
    loadsNew_ = true;
}

DynamicsSettings Simulation::chosen(double duration, DynamicsColumns const& columns,
                                    std::span<TouchingPair const> touching) {
    DynamicsSettings chosen = settings_;
    chosen.scale = engineScale_;
    double const share = shareOf(duration);
    chosen.substeps = static_cast<int>(std::ceil(share * chosen.substeps));
    bool const automatic = settings_.substeps == DynamicsSettings::automatic;
    bool const own = engine_->chooseSubsteps(automatic) && automatic;
    if (automatic) {
        bool const otherLoads = loadsNew_ && loads_.changedMuch();
        loadsNew_ = false;
        if (otherLoads || jointsNew_ || duration != demandFor_) {
            findJointDemand(duration, columns);
        }
        if (!own && (otherLoads || contactsNew_)) {
            findContactDemand(columns, touching);
        }
        double fastest = 0;
        double spin = 0;
        std::size_t moving = 0;
        if (own) {
            chosen.substeps = roundedSubsteps(std::max(jointSubsteps_, share * leastSubsteps));
            choice_.substeps = static_cast<int>(std::lround(chosen.substeps / share));
            choice_.velocityIterations = chosen.velocityIterations;
            choice_.scale = chosen.scale;
            return chosen;
        }
        for (Body const& body : bodies_.bodies()) { // objects without bodies may have any velocity
            if (body.object.valid() && !body.fixed) {
                ++moving;
                Vec2 const velocity = columns.velocity.values()[body.rows.velocity].value;
                fastest = std::max(fastest, std::abs(velocity.x) + std::abs(velocity.y));
                spin = std::max(spin, std::abs(columns.spin.values()[body.rows.spin].value));
            }
        }
        double const motion =
            duration * std::max(fastest * engineScale_ / farthestPerStep, spin / widestPerStep);
        bool const flies = !touching_.any() && joints_.joints().empty() && rates_.unforeseen > 0;
        double const least = flies ? 1 : leastSubsteps;
        double const swings = duration * rates_.ahead / swingPerStep;
        double const heaped =
            moving >= manyBodies && touching_.any()
                ? std::min(substepsOfMany, frameDuration * rates_.ahead / swingPerStepOfMany)
                : 0;
        chosen.substeps = roundedSubsteps(
            std::max({share * std::max({least, contactSubsteps_, heaped}), jointSubsteps_, motion, swings}));
        chosen.velocityIterations = std::max(chosen.velocityIterations, contactRounds_);
        if (settling_ > 0) {
            --settling_;
            if (settles_) {
                chosen.substeps = static_cast<int>(std::ceil(share * settlingSubsteps));
                chosen.velocityIterations = std::max(chosen.velocityIterations, settlingIterations);
            }
        }
    }
    choice_.substeps = static_cast<int>(std::lround(chosen.substeps / share));
    choice_.velocityIterations = chosen.velocityIterations;
    choice_.scale = chosen.scale;
    return chosen;
}

bool Simulation::step(double duration, DynamicsColumns const& columns,
                      std::span<TouchingPair const> touching) {
    if (!engine_->anyAwake()) {
        failures_ = 0;
        return false;
    }
    DynamicsSettings const with = chosen(duration, columns, touching);
    engine_->step(duration, with);
    checkMotion();
    failures_ = 0;
    substep_ = duration / with.substeps;
    // A force that is held throughout acts, on average, half of the time late, unless the engine makes up for
    // some of it.
    lag_ = {duration, engine_->exactForConstantForces() ? 0 : duration / with.substeps};
    loads_.noteSleepers(*engine_, with.sleeping);
    return true;
}

void Simulation::checkMotion() const {
    // Zero times a finite number is zero, zero times any other is NaN: so one test suffices for all bodies.
    double sum = 0;
    for (MovedBody const& moved : engine_->moved()) {
        Motion const& motion = moved.motion;
        sum += 0 * ((motion.centre.x + motion.centre.y) + (motion.velocity.x + motion.velocity.y) +
                    (motion.angle + motion.spin));
    }
    if (sum != 0) {
        throw EngineFailure("a body's place or speed is no finite number");
    }
}

void Simulation::takeOver(EngineState const& state) {
    state_ = state;
    if (state_.gaveUp == level_) {
        maker_ = standIn_;
        stoodIn_ = true;
    }
}

void Simulation::giveUp(EngineFailure const& failure) {
    if (!state_.troubled()) {
        state_.why = failure.what();
    }
    if (!stoodIn_ && maker_ != standIn_) {
        state_.gaveUp = level_;
        maker_ = standIn_;
        stoodIn_ = true;
    } else {
        // Bodies whose numbers are not finite are held still from now on; all bodies, if these cannot be
        // found or if that does not help.
        std::vector<ObjectId> stopping;
        if (engine_ && ++failures_ < mostFailures) {
            for (SlotIndex const slot : engine_->lost()) {
                if (!bodies_[slot].fixed) { // fixed bodies are put back
                    stopping.push_back(bodies_[slot].object);
                }
            }
        }
        if (stopping.empty()) {
            for (Body const& body : bodies_.bodies()) {
                if (body.object.valid() && !body.fixed) {
                    stopping.push_back(body.object);
                }
            }
        }
        if (stopping.empty()) {
            throw std::runtime_error(std::string("dynamics cannot go on: ") + failure.what());
        }
        state_.stopped.insert(state_.stopped.end(), stopping.begin(), stopping.end());
        std::sort(state_.stopped.begin(), state_.stopped.end());
    }
    if (!failure.intact()) {
        abandon(std::move(engine_));
    }
    engine_ = nullptr;
    loadsStale_ = true;
}

} // namespace trembler
