// The nearest miss of each goal in a run.
#pragma once

#include "insight/miss/aftermath.hpp"
#include "insight/miss/current/insulators.hpp"
#include "insight/miss/current/nearest_circuits.hpp"
#include "insight/run/level_runs.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace trembler::insight {

/// How nearly a goal was met.
struct GoalMiss {
    std::string id; ///< as in GoalStatus
    /// The frame in which it was first met, if it was; `nearest` is then of measure 0.
    std::optional<std::uint64_t> met;
    Miss nearest; ///< the earliest of the least measure
};

/// How nearly a level was solved.
struct LevelMiss {
    std::vector<GoalMiss> goals;
    /// The least measure of the whole condition, in [0, 1]: of goals that must all be met, their mean at one
    /// moment. 0: solved; 1 if there are no goals. For a search to minimise.
    double measure = 1;
    std::uint64_t frame = 0; ///< in which it was that
};

/// Measures a run frame by frame: a pure function of what happens in it. Not thread-safe.
class MissMeter {
public:
    /// The requested results: a search needs no more than the measure of each run.
    enum class For : std::uint8_t {
        measure, ///< the nearest misses
        /// also the lift a liquid lacked, the end of a goal that held too briefly, wires that were cut, and
        /// how nearly the circuits of magnets were closed
        explanation,
    };

    /// Sets itself up for a world that was built from the level, before its first frame. `level` must outlive
    /// it. Throws InputError if the goals are wrong.
    MissMeter(LevelFile const& level, World const& world, For what = For::measure);
    ~MissMeter();
    MissMeter(MissMeter const&) = delete;
    MissMeter& operator=(MissMeter const&) = delete;

    /// To be called after every frame.
    void look(World const& world);
    [[nodiscard]] LevelMiss const& result() const { return result_; }
    /// The nearest miss of a goal, by its place in the result, with the reason why it ended among
    /// Miss::besides, and the circuits there at their own best moments, see NearestCircuits.
    [[nodiscard]] GoalMiss explained(std::size_t goal) const;

private:
    /// Notes the nearest miss of a goal so far, and its explanation.
    void keepNearest(std::size_t goal, Miss miss, World const& world);
    /// Notes how nearly the circuits of magnets are closed since the goal's present step began.
    void lookAtCircuits(std::size_t goal, World const& world);
    [[nodiscard]] ConditionMiss const& conditionOf(std::size_t goal) const;

    std::optional<Condition> condition_;
    std::unique_ptr<ConditionState> state_;
    std::unique_ptr<ConditionMiss> miss_;
    CircuitSight circuits_;
    Insulators insulators_;
    For what_ = For::measure;
    std::vector<Aftermath> after_; // of each goal
    struct Circuits {
        NearestCircuits nearest;
        std::size_t step = 0; // of a sequence
    };
    std::vector<Circuits> nearestCircuits_; // of each goal
    bool split_ = false;                    // each child of the condition is a goal
    LevelMiss result_;
    std::uint64_t ticks_ = 0;
};

} // namespace trembler::insight
