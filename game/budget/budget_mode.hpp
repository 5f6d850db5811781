// The budget mode of a session and the figures that the panel shows: measures, estimates, decides and applies
// changes.
#pragma once

#include "game/budget/controller.hpp"
#include "game/budget/knobs.hpp"
#include "puzzle/session/session.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace trembler::budget {

/// A change that the budget mode has made.
struct Decision {
    std::uint64_t frame = 0; ///< first frame that is computed with the change
    std::string effect;
    std::string from; ///< names of options
    std::string to;
    double microseconds = 0; ///< per frame, expected saving; negative: an expected cost
    Error error;             ///< estimated error of the new option
    std::string of;
};

/// "Buoyancy: exact -> 64 particles: saves 1.2 ms, error 2 % of the lift".
[[nodiscard]] std::string inWords(Decision const& decision);

/// Costs nothing while it is off and unobserved. Reads the world between frames; makes changes through
/// Session::change, so that a recording repeats them without reading a clock. Not thread-safe.
class BudgetMode {
public:
    /// Frames in a round of measuring, estimating and deciding.
    static constexpr std::uint64_t round = 60;
    /// Frames after a change that are not measured, because new components allocate memory in them.
    static constexpr std::uint64_t settling = 5;

    /// Source of the times: World::status() unless a test injects another.
    using Stopwatch = std::function<std::vector<ComponentStatus>(World const&)>;
    explicit BudgetMode(Registry const& registry, Stopwatch stopwatch = {});

    /// µs per frame, above 0; nullopt: off. The mean of each round is kept to it; single frames may take
    /// longer.
    void setBudget(std::optional<double> microseconds) { budget_ = microseconds; }
    [[nodiscard]] std::optional<double> budget() const { return budget_; }
    /// Whether a panel reads figures() and knobs() even while the budget is off.
    void watch(bool watching) { watching_ = watching; }

    /// Call directly before each Session::step. Without `decide` it measures and estimates but changes
    /// nothing.
    void beforeStep(Session& session, bool decide = true);
    /// Estimates all options again at once; the world need not run.
    void look(World const& world);
    /// Whether the knobs are out of date: they belong to another run, were never estimated, or detail
    /// levels, periods or the objects of a world that has not started have changed since.
    [[nodiscard]] bool stale(World const& world) const;
    /// Forgets everything but the budget: call it when another level is opened.
    void clear();

    /// Figures of the last round.
    struct Figures {
        std::uint64_t frame = 0;                       ///< 0: none yet
        double microseconds = 0;                       ///< per frame, mean of the round, of all components
        double worst = 0;                              ///< µs, of the slowest frame of the round
        std::map<std::string, double> effects;         ///< µs per frame, by effect
        std::map<std::string, double> componentsTimes; ///< µs per frame, by title
    };
    [[nodiscard]] Figures const& figures() const { return figures_; }
    [[nodiscard]] std::vector<Knob> const& knobs() const { return knobs_; }
    [[nodiscard]] Knob const* knob(std::string const& effect) const;
    /// The sum of the errors of all knobs, in m after one second.
    [[nodiscard]] double error() const;
    /// The decisions of this run, the latest last.
    [[nodiscard]] std::vector<Decision> const& decisions() const { return decisions_; }
    /// Whether, at the last decision, no allowed combination of options kept to the budget.
    [[nodiscard]] bool hopeless() const { return controller_.hopeless(); }
    /// Whether the budget was kept in the last round.
    [[nodiscard]] bool kept() const { return !budget_ || figures_.microseconds <= *budget_; }

private:
    void startMeasuring(World const& world);
    void finishRound(Session& session, bool decide);
    void decide(Session& session);

    Registry const& registry_;
    Stopwatch stopwatch_;
    std::optional<double> budget_;
    bool watching_ = false;
    MotionLog log_;
    Controller controller_;
    std::vector<Knob> knobs_;
    std::uint64_t knobsFrame_ = 0; // of the world when the knobs were estimated
    WorldOptions knobsOptions_;    // the world's detail levels and periods at that time
    std::uint64_t knobsStructure_ = 0;
    Figures figures_;
    std::vector<Decision> decisions_;
    std::uint64_t lastFrame_ = 0;
    std::uint64_t measureFrom_ = 0; // frame
    bool measuring_ = false;
    std::map<std::string, double> before_; // µs in total, by title, when measuring began
    double lastTotal_ = 0;                 // µs, of all components, after the last frame
    double worst_ = 0;
};

} // namespace trembler::budget
