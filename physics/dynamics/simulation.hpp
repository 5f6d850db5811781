// Bodies, joints, loads and contacts around an engine: all of Dynamics that depends neither on which engine
// it is nor on how a resolver gets at its properties.
#pragma once

#include "physics/dynamics/causes.hpp"
#include "physics/dynamics/loads.hpp"
#include "physics/dynamics/solver_choice.hpp"
#include "physics/dynamics/touching.hpp"

#include <memory>

namespace trembler {

class Simulation {
public:
    explicit Simulation(EngineMaker maker) : maker_(maker) {}

    /// Brings bodies and joints into line with the columns. Cheap while these have not changed. Objects that
    /// are not sound are left out and returned, each time it has had to look at them.
    [[nodiscard]] std::vector<Refusal> follow(DynamicsColumns const& columns);
    /// True if loads must be summed anew, because bodies came or went.
    [[nodiscard]] bool loadsStale() const { return loadsStale_; }
    void startLoads() { loads_.clear(bodies_.bodies().size()); }
    void endLoads();
    /// Moves everything on by `duration` (s); returns false if all is at rest and nothing was done.
    bool step(double duration, DynamicsColumns const& columns);
    /// To be told whenever the pairs that touch have changed.
    void noteContacts(DynamicsColumns const& columns, std::span<TouchingPair const> touching);
    /// What the last step was computed with.
    [[nodiscard]] SolverChoice const& choice() const { return choice_; }
    /// To be told after the moved bodies have been written into the columns: these versions are its own
    /// doing.
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
    void noteDemand(double gravity, DynamicsColumns const& columns);
    void forgetDemand();
    [[nodiscard]] DynamicsSettings chosen(double duration, DynamicsColumns const& columns);

    EngineMaker maker_;
    std::unique_ptr<Engine> engine_;
    DynamicsSettings settings_; // as stated
    SolverChoice choice_;
    double engineScale_ = 0;     // that the engine was made with
    double jointSubsteps_ = 0;   // that the joints ask for
    double contactSubsteps_ = 0; // that the contacts ask for
    int contactRounds_ = 0;      // of the solver, that they ask for
    double demandGravity_ = -1;  // m/s², that the joints' demand was found for
    int settling_ = 0;           // frames in which new joints still look for their loads
    BodyTable bodies_;
    JointTable joints_;
    LoadTable loads_;
    TouchBook touching_;
    CauseBook causes_;
    bool loadsStale_ = true;
    std::uint64_t bodiesVersion_ = 0;
    std::uint64_t jointsVersion_ = 0;
    std::uint64_t motionVersion_ = 0;
    std::uint64_t motionStructure_ = 0;
};

} // namespace trembler
