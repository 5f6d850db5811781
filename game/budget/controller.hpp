// Decides, round by round, which options keep to a time budget. Has no access to a clock, the world or an
// effect: the same figures always lead to the same decisions.
#pragma once

#include "game/budget/plan.hpp"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace trembler::budget {

/// A knob's figures at the end of a round.
struct KnobFigures {
    struct Option {
        std::string name;
        double work = 1;  ///< > 0, relative cost as far as known beforehand
        double error = 0; ///< m, see Error
        bool allowed = true;
    };
    std::string name;
    std::vector<Option> options;
    std::size_t current = 0;
    /// Per frame, measured at the current option; 0: the effect does nothing in this scene.
    double microseconds = 0;
};

class Controller {
public:
    /// Shares of the budget that may be used, which leaves room for noise: when accuracy is added, and when
    /// cost must be reduced.
    static constexpr double roomForMore = 0.90;
    static constexpr double roomForLess = 0.95;
    /// A change that the budget does not force must reduce the error to this share of it or less.
    static constexpr double worthwhile = 0.8;
    /// Errors below this, in m after one second, are invisible and count as equal.
    static constexpr double unseen = 1e-4;
    static constexpr std::uint64_t mostPatience = 64; ///< rounds

    /// Returns the index of the option for each knob, in their order. `rest`: µs per frame of all components
    /// that no knob changes; `budget`: µs per frame for everything.
    ///
    /// An option that is not allowed is left at once. Over the budget, the plan with the least error that
    /// costs 95 % of it is taken if it saves at least 2 %. Within the budget, a plan that costs 90 % of it is
    /// taken if its error is a fifth less. Where no allowed plan is cheap enough, any that costs at most 5 %
    /// more than the cheapest counts as cheap enough. A knob whose effect does nothing in the scene keeps its
    /// option. After a change one round passes before the next change, so that the cost of the new options is
    /// measured. A change that is not forced and leads back to a combination that was used before makes the
    /// next such change wait for twice as many rounds: noisy figures cannot make the plan oscillate.
    ///
    /// The cost of an option that has not been tried follows from the current option's measured cost and the
    /// ratio of their works; for an option that has been tried, from the ratio that was measured then.
    [[nodiscard]] std::vector<std::size_t> decide(std::span<KnobFigures const> knobs, double rest,
                                                  double budget);

    /// Whether, as of the last decision, nothing allowed was cheap enough.
    [[nodiscard]] bool hopeless() const { return hopeless_; }
    /// µs per frame that an option of a knob would cost.
    [[nodiscard]] double predicted(KnobFigures const& knob, std::size_t option) const;
    /// Forgets everything but the measured costs of options: call it for another budget or another scene.
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

    std::map<Key, double> corrections_; // factors on the works, from measurements
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
