// Bodies, joints, loads and contacts around an engine: the part of Dynamics that depends neither on the
// engine nor on how a resolver accesses its properties.
#pragma once

#include "physics/dynamics/calls.hpp"
#include "physics/dynamics/core/causes.hpp"
#include "physics/dynamics/core/loads.hpp"
#include "physics/dynamics/core/touching.hpp"
#include "physics/dynamics/properties/engine_state.hpp"
#include "physics/dynamics/properties/force_lag.hpp"
#include "physics/dynamics/properties/force_rates.hpp"
#include "physics/dynamics/properties/solver_choice.hpp"

#include <memory>

namespace trembler {

class Simulation {
public:
    /// `standIn` makes the engine that takes over if the first fails; they may be the same. `level` names the
    /// first.
    Simulation(EngineMaker maker, std::string_view level, EngineMaker standIn)
        : maker_(maker), level_(level), standIn_(standIn) {}

    /// Continues from the state of an earlier simulation. To be called before any other function.
    void takeOver(EngineState const& state);
    /// To be called when any function of this class, or of its engine, has thrown: from then on another
    /// engine computes the motion, or the same one with some bodies held still. follow() and all calls after
    /// it must then be made again.
    void giveUp(EngineFailure const& failure);
    /// All failures so far.
    [[nodiscard]] EngineState const& state() const { return state_; }

    /// Updates bodies and joints from the columns. Cheap while these have not changed. Invalid objects are
    /// left out and returned each time they are checked.
    [[nodiscard]] std::vector<Refusal> follow(DynamicsColumns const& columns);
    /// True if loads must be summed again, because bodies were added or removed.
    [[nodiscard]] bool loadsStale() const { return loadsStale_; }
    void startLoads() {
        loads_.clear(bodies_.bodies().size());
        rates_ = {};
    }
    void endLoads();
    void noteRate(StateRate const& call);
    /// The summary of all calls of noteRate() since startLoads().
    [[nodiscard]] ForceRates const& rates() const { return rates_; }
    /// Computes the motion for `duration` (s), given the pairs that touch; returns false if all bodies are at
    /// rest and nothing was done.
    bool step(double duration, DynamicsColumns const& columns, std::span<TouchingPair const> touching);
    /// Whether the next step depends on which pairs touch: the automatic choice of substeps does.
    [[nodiscard]] bool readsTouches() const { return settings_.substeps == DynamicsSettings::automatic; }
    /// To be called whenever the pairs that touch have changed.
    void noteContacts() { contactsNew_ = true; }
    /// The settings with which the last step was computed.
    [[nodiscard]] SolverChoice const& choice() const { return choice_; }
    [[nodiscard]] ForceLag const& lag() const { return lag_; }
    /// The length (s) of the engine's last substeps, for which it states impulses.
    [[nodiscard]] double substep() const { return substep_; }
    /// To be called after the moved bodies have been written into the columns, so that the new versions do
    /// not count as changes by others.
    void noteWritten(DynamicsColumns const& columns) { motionVersion_ = columns.motionVersion(); }

    [[nodiscard]] Engine& engine() { return *engine_; }
    [[nodiscard]] bool anyAwake() const { return engine_ && engine_->anyAwake(); }
    [[nodiscard]] BodyTable const& bodies() const { return bodies_; }
    [[nodiscard]] JointTable const& joints() const { return joints_; }
    [[nodiscard]] LoadTable& loads() { return loads_; }
    [[nodiscard]] TouchBook& touching() { return touching_; }
    [[nodiscard]] CauseBook& causes() { return causes_; }

private:
    void makeEngine(DynamicsSettings const& settings, DynamicsColumns const& columns);
    [[nodiscard]] double scaleNow(DynamicsSettings const& settings, DynamicsColumns const& columns) const;
    void findJointDemand(double duration, DynamicsColumns const& columns);
    void findContactDemand(DynamicsColumns const& columns, std::span<TouchingPair const> touching);
    void forgetDemand();
    [[nodiscard]] DynamicsSettings chosen(double duration, DynamicsColumns const& columns,
                                          std::span<TouchingPair const> touching);

    void checkMotion() const;

    EngineMaker maker_;
    std::string_view level_;
    EngineMaker standIn_;
    bool stoodIn_ = false; // maker_ is standIn_
    EngineState state_;
    int failures_ = 0; // in this frame
    std::unique_ptr<Engine> engine_;
    DynamicsSettings settings_; // as stated
    SolverChoice choice_;
    ForceLag lag_;
    double substep_ = 0;         // s
    double engineScale_ = 0;     // of the present engine
    double jointSubsteps_ = 0;   // that the joints need
    double contactSubsteps_ = 0; // that the contacts need
    int contactRounds_ = 0;      // iterations that the contacts need
    double demandFor_ = 0;       // s, duration of the turn for which the joints' demand was computed
    bool jointsNew_ = true;      // since their demand was computed
    bool contactsNew_ = true;    // likewise
    bool loadsNew_ = false;      // likewise
    int settling_ = 0;           // frames left for computing the loads of new joints
    bool settles_ = false;       // these need more iterations than usual
    BodyTable bodies_;
    JointTable joints_;
    LoadTable loads_;
    ForceRates rates_;
    TouchBook touching_;
    CauseBook causes_;
    bool loadsStale_ = true;
    std::uint64_t bodiesVersion_ = 0;
    std::uint64_t jointsVersion_ = 0;
    std::uint64_t motionVersion_ = 0;
    std::uint64_t motionStructure_ = 0;
};

} // namespace trembler
