// The guarantees of the controller, in models that consist of costs only.
#include "game/budget/controller.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace trembler::budget {
namespace {

/// A model of a world by its costs alone: the true time of each option, which may differ from its `work`.
struct Costs {
    std::vector<KnobFigures> knobs;
    std::vector<std::vector<double>> truth; ///< µs
    double rest = 0;

    [[nodiscard]] double now() const {
        double sum = rest;
        for (std::size_t i = 0; i < knobs.size(); ++i) {
            sum += truth[i][knobs[i].current];
        }
        return sum;
    }
    void measure(std::function<double()> const& noise) {
        for (std::size_t i = 0; i < knobs.size(); ++i) {
            knobs[i].microseconds = truth[i][knobs[i].current] * noise();
        }
    }
};

Costs someCosts() {
    Costs costs;
    int const count = *rc::gen::inRange(1, 4);
    for (int k = 0; k < count; ++k) {
        KnobFigures knob;
        knob.name = "knob " + std::to_string(k);
        std::vector<double> truth;
        int const options = *rc::gen::inRange(2, 6);
        for (int i = 0; i < options; ++i) {
            truth.push_back(10 + *rc::gen::inRange(0, 1000));
            double const misjudged = std::exp2(*rc::gen::inRange(-20, 21) / 10.0); // by up to four times
            knob.options.push_back({"option " + std::to_string(i), truth.back() * misjudged,
                                    *rc::gen::inRange(0, 1000) / 1000.0, *rc::gen::inRange(0, 6) > 0});
        }
        knob.options.front().allowed = true;
        knob.current = static_cast<std::size_t>(*rc::gen::inRange(0, options));
        costs.knobs.push_back(std::move(knob));
        costs.truth.push_back(std::move(truth));
    }
    costs.rest = *rc::gen::inRange(0, 200);
    return costs;
}

/// A source of noise that RapidCheck's shrinking does not change: a linear congruential generator (Knuth).
class Noise {
public:
    explicit Noise(std::uint64_t seed) : state_(seed) {}
    double operator()(double amplitude) {
        state_ = 6364136223846793005ULL * state_ + 1442695040888963407ULL;
        return 1 + amplitude * (static_cast<double>(state_ >> 11) / 4503599627370496.0 - 1);
    }

private:
    std::uint64_t state_;
};

TEST(BudgetController, SettlesAndKeepsTheBudgetIfPossible) {
    EXPECT_TRUE(rc::check([] {
        Costs costs = someCosts();
        double const budget = 50 + *rc::gen::inRange(0, 2500);
        Noise noise(static_cast<std::uint64_t>(*rc::gen::inRange(1, 1000000)));
        Controller controller;
        int lateChanges = 0;
        for (std::size_t round = 1; round <= 150; ++round) {
            costs.measure([&] { return noise(0.02); });
            auto const plan = controller.decide(costs.knobs, costs.rest, budget);
            bool changed = false;
            for (std::size_t i = 0; i < plan.size(); ++i) {
                RC_ASSERT(costs.knobs[i].options[plan[i]].allowed);
                changed = changed || plan[i] != costs.knobs[i].current;
                costs.knobs[i].current = plan[i];
            }
            lateChanges += changed && round > 100 ? 1 : 0;
        }
        // Figures that vary by 2 % cause no further changes, unless a plan costs as much as a limit to within
        // that noise. Then it is left once, or left and tried again after the greatest patience, 64 rounds.
        RC_ASSERT(lateChanges <= 2);
        double cheapest = costs.rest;
        for (std::size_t i = 0; i < costs.knobs.size(); ++i) {
            double least = std::numeric_limits<double>::infinity();
            for (std::size_t j = 0; j < costs.truth[i].size(); ++j) {
                least = costs.knobs[i].options[j].allowed ? std::min(least, costs.truth[i][j]) : least;
            }
            cheapest += least;
        }
        // With figures that are four times too high the controller may miss the cheapest plan, but not if the
        // budget is large enough.
        if (cheapest <= budget / 16) {
            RC_ASSERT(costs.now() <= 1.03 * budget);
        }
    }));
}

TEST(BudgetController, DoesNotOscillateWithNoisyFigures) {
    EXPECT_TRUE(rc::check([] {
        Costs costs = someCosts();
        double const budget = 50 + *rc::gen::inRange(0, 2500);
        Noise noise(static_cast<std::uint64_t>(*rc::gen::inRange(1, 1000000)));
        Controller controller;
        int changes = 0;
        constexpr int rounds = 400;
        for (int round = 1; round <= rounds; ++round) {
            costs.measure([&] { return noise(0.5); }); // a computer under other load
            auto const plan = controller.decide(costs.knobs, costs.rest, budget);
            bool changed = false;
            for (std::size_t i = 0; i < plan.size(); ++i) {
                changed = changed || plan[i] != costs.knobs[i].current;
                costs.knobs[i].current = plan[i];
            }
            changes += changed ? 1 : 0;
        }
        RC_ASSERT(changes <= rounds / 6);
    }));
}

TEST(BudgetController, LearnsWhatAnOptionCosts) {
    Costs costs;
    costs.knobs.push_back(
        {"gravity", {{"real", 100, 0, true}, {"tree", 10, 0.5, true}, {"linear", 1, 2, true}}, 0, 0});
    costs.truth.push_back({100, 90, 5}); // the tree is slower than its figure
    Controller controller;
    std::vector<std::size_t> went;
    for (int round = 0; round < 12; ++round) {
        costs.measure([] { return 1.0; });
        costs.knobs[0].current = controller.decide(costs.knobs, 0, 50).front();
        went.push_back(costs.knobs[0].current);
    }
    EXPECT_FALSE(controller.hopeless());
    EXPECT_EQ(went.front(), 1U) << "by its figure, the tree is cheap enough";
    EXPECT_EQ(went.back(), 2U) << "by measurement, it is not";
    EXPECT_EQ(std::count(went.begin(), went.end(), 1U), 2) << "tried once, for the round of its measurement";
}

TEST(BudgetController, KeepsAccuracyIfTheBudgetCannotBeKept) {
    Costs costs;
    costs.knobs.push_back({"dynamics", {{"4 steps", 400, 0.01, true}, {"2 steps", 200, 0.02, true}}, 0, 0});
    costs.knobs.push_back({"gravity", {{"real", 8, 0, true}, {"real, every 4 frames", 2, 0.1, true}}, 1, 0});
    costs.truth = {{400, 200}, {8, 2}};
    Controller controller;
    for (int round = 0; round < 8; ++round) {
        costs.measure([] { return 1.0; });
        auto const plan = controller.decide(costs.knobs, 0, 50);
        costs.knobs[0].current = plan[0];
        costs.knobs[1].current = plan[1];
    }
    EXPECT_EQ(costs.knobs[0].current, 1U);
    EXPECT_TRUE(controller.hopeless());
    EXPECT_EQ(costs.knobs[1].current, 0U) << "6 µs less would not have been enough";
}

TEST(BudgetController, MakesNoChangeWithoutAGain) {
    Costs costs;
    costs.knobs.push_back({"gravity", {{"a", 100, 0.010, true}, {"b", 100, 0.009, true}}, 0, 0});
    costs.truth.push_back({100, 100});
    Controller controller;
    for (int round = 0; round < 5; ++round) {
        costs.measure([] { return 1.0; });
        EXPECT_EQ(controller.decide(costs.knobs, 0, 1000).front(), 0U)
            << "a tenth of the error is too small a gain";
    }
    costs.knobs[0].options[1].error = 0.005;
    EXPECT_EQ(controller.decide(costs.knobs, 0, 1000).front(), 1U);
    costs.knobs[0].options[0].error = 9e-5;
    costs.knobs[0].options[1].error = 1e-7;
    costs.knobs[0].current = 0;
    EXPECT_EQ(Controller().decide(costs.knobs, 0, 1000).front(), 0U) << "errors below 0.1 mm count as equal";
}

TEST(BudgetController, LeavesSleepingEffectsUnchanged) {
    KnobFigures const asleep{"magnetism", {{"grid", 1, 0.5, true}, {"pairwise", 10, 0, true}}, 0, 0};
    std::vector<KnobFigures> const knobs{asleep};
    EXPECT_EQ(Controller().decide(knobs, 10, 1000).front(), 0U);
    KnobFigures forbidden = asleep;
    forbidden.options[0].allowed = false;
    std::vector<KnobFigures> const others{forbidden};
    EXPECT_EQ(Controller().decide(others, 10, 1000).front(), 1U) << "unless it must not stay";
}

} // namespace
} // namespace trembler::budget
