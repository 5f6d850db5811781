// Decides, round by round, which choices a time budget calls for. Knows no clock, no world and no effect: the
// same figures always lead to the same decisions.
#pragma once

#include "game/budget/plan.hpp"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace trembler::budget {

/// A knob as it is at the end of a round.
struct KnobFigures {
    struct Option {
        std::string name;
        double work = 1;  ///< > 0, in proportion to what it costs, as far as known beforehand
        double error = 0; ///< m, see Error
        bool allowed = true;
    };
    std::string name;
    std::vector<Option> options;
    std::size_t current = 0;
    double microseconds = 0; ///< per frame, measured at the current option; 0: it sleeps
};

class Controller {
public:
    /// What is left of the budget for noise when something is added, and when something must go.
    static constexpr double roomForMore = 0.90;
    static constexpr double roomForLess = 0.95;
    /// Nothing changes of its own accord for less than a fifth of the error.
    static constexpr double worthwhile = 0.8;
    /// Below this, m after a second, nobody can tell errors apart.
    static constexpr double unseen = 1e-4;
    static constexpr std::uint64_t mostPatience = 64; ///< rounds

    /// The option for each knob, in their order. `rest`: µs per frame of all that no knob changes; `budget`:
    /// µs per frame for everything.
    ///
    /// An option that is not allowed is left at once. Over the budget, the plan with the least error that
    /// costs 95 % of it is taken if it saves at least 2 %. Within the budget, a plan that costs 90 % of it is
    /// taken if its error is a fifth less. Where nothing allowed is so cheap, what costs 5 % more than the
    /// cheapest counts as cheap enough. A knob that sleeps stays where it is. After a change a round passes
    /// before the next, so that its cost is known. A change that nothing forces and that leads back to where
    /// it has been before makes the next such change wait for twice as many rounds: however the figures
    /// waver, it does not flip to and fro.
    ///
    /// What an option costs that has not been tried follows from what the current one costs and from their
    /// works; what has been tried, from the ratio that was measured then.
    [[nodiscard]] std::vector<std::size_t> decide(std::span<KnobFigures const> knobs, double rest,
                                                  double budget);

    /// Whether, as of the last decision, nothing allowed was cheap enough.
    [[nodiscard]] bool hopeless() const { return hopeless_; }
    /// µs per frame that an option of a knob would cost.
    [[nodiscard]] double predicted(KnobFigures const& knob, std::size_t option) const;
    /// Forgets all but what options cost: another budget, another scene.
    void forgetPlans();

private:
    using Key = std::pair<std::string, std::string>; // knob and option
    struct Tried {
        Key from;
        double microseconds = 0;
        double ratioOfWorks = 1; // of the new one to the old one
    };

    void learn(std::span<KnobFigures const> knobs);
    [[nodiscard]] double correction(Key const& key, double otherwise) const;

    std::map<Key, double> corrections_; // of the works, by what was measured
    std::map<Key, Tried> tried_;        // by the option that is being tried
    std::set<std::string> visited_;     // combinations
    double budget_ = 0;
    bool hopeless_ = false;
    std::uint64_t round_ = 0;
    std::uint64_t quietUntil_ = 0;
    std::uint64_t patientUntil_ = 0;
    std::uint64_t patience_ = 1;
};

} // namespace trembler::budget
