// The budget mode of a session, and what the panel shows of it: measures, estimates, decides, changes.
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

/// A change that the mode has made.
struct Decision {
    std::uint64_t frame = 0; ///< the first that it counts for
    std::string effect;
    std::string from; ///< names of options
    std::string to;
    double microseconds = 0; ///< per frame that it was expected to save; below zero: to cost
    Error error;             ///< as estimated for what it went to
    std::string of;
};

/// "Buoyancy: exact -> 64 particles: saves 1.2 ms, error 2 % of the lift".
[[nodiscard]] std::string inWords(Decision const& decision);

/// Off and unobserved it costs nothing. It reads the world between frames; what it changes, it changes
/// through Session::change, so that a recording repeats it without any clock. Not thread-safe.
class BudgetMode {
public:
    /// Frames that a round takes: measure, estimate, decide.
    static constexpr std::uint64_t round = 60;
    /// After a change the first frames make room for new things and do not count.
    static constexpr std::uint64_t settling = 5;

    /// Where times come from: what World::status() says unless tests know better.
    using Stopwatch = std::function<std::vector<ComponentStatus>(World const&)>;
    explicit BudgetMode(Registry const& registry, Stopwatch stopwatch = {});

    /// µs per frame, above 0; none: off. Means of a round are kept to it, single frames may take longer.
    void setBudget(std::optional<double> microseconds) { budget_ = microseconds; }
    [[nodiscard]] std::optional<double> budget() const { return budget_; }
    /// Whether somebody looks at figures() and knobs() even while it is off.
    void watch(bool watching) { watching_ = watching; }

    /// To be called directly before each Session::step. Without `decide` it only measures and estimates.
    void beforeStep(Session& session, bool decide = true);
    /// Estimates again at once; the world need not run.
    void look(World const& world);
    /// Whether the knobs are those of another run, or of none, or of before something was changed.
    [[nodiscard]] bool stale(World const& world) const;
    /// Another level: forgets everything but the budget.
    void clear();

    /// As of the last round.
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
    /// The sum of the errors of all knobs, m after a second.
    [[nodiscard]] double error() const;
    /// Of this run, the latest last.
    [[nodiscard]] std::vector<Decision> const& decisions() const { return decisions_; }
    /// Whether, as of the last decision, nothing that would do was cheap enough.
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
    std::uint64_t knobsFrame_ = 0; // of the world that they were looked up in
    WorldOptions knobsOptions_;    // its levels and periods then
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
