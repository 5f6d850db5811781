// The levels of electricity that are allowed: those with the same objects on.
#include "physics/electricity/properties/electrical.hpp"
#include "tests/game/budget/knob_kit.hpp"

#include <vector>

namespace trembler::budget {
namespace electricity_knob_test {
namespace {

class ElectricityKnob : public KnobTest {
protected:
    /// Opens the level with this option in force from the third frame on, and returns the objects that are on
    /// in some frames.
    std::vector<std::vector<ObjectId>> onWith(std::string const& file, Option const& option) {
        open(file);
        runTo(2);
        for (RecordedChange const& change : option.makes) {
            session().change(change);
        }
        std::vector<std::vector<ObjectId>> frames;
        for (int frame = 0; frame < 240; ++frame) {
            step();
            frames.emplace_back();
            for (ElectricalState::Entry const& entry : world().find<ElectricalState>()->byIndex) {
                if (entry.on) {
                    frames.back().push_back(entry.object);
                }
            }
        }
        return frames;
    }
};

TEST_F(ElectricityKnob, IsNeverBelowTheLevelThatTheCircuitsNeed) {
    open("2-doorbell.json");
    runTo(2);
    auto const knob = electricityKnob(world());
    ASSERT_TRUE(knob);
    for (Option const& option : knob->options) {
        bool const single = option.name == "single-cable";
        EXPECT_EQ(option.cannot.empty(),
                  option.name != "flow" && (!single || knob->options[knob->current].name == "single-cable"))
            << option.name;
    }
}

TEST_F(ElectricityKnob, OptionsTurnTheSameObjectsOn) {
    for (char const* const file : {"1-switched-electromagnet.json", "2-doorbell.json"}) {
        open(file);
        runTo(2);
        auto const knob = electricityKnob(world());
        ASSERT_TRUE(knob);
        auto const now = onWith(file, knob->options[knob->current]);
        std::size_t switched = 0;
        for (std::size_t frame = 1; frame < now.size(); ++frame) {
            switched += now[frame] != now[frame - 1] ? 1 : 0;
        }
        EXPECT_GT(switched, 0U) << "nothing ever happens in " << file;
        std::size_t others = 0;
        for (std::size_t i = 0; i < knob->options.size(); ++i) {
            if (i != knob->current && knob->options[i].cannot.empty()) {
                EXPECT_EQ(onWith(file, knob->options[i]), now) << file << ", " << knob->options[i].name;
                ++others;
            }
        }
        EXPECT_GT(others, 0U) << file;
    }
}

TEST_F(ElectricityKnob, EveryOptionCanBeMadeAndIsThenTheCurrentOne) {
    open("2-doorbell.json");
    runTo(2);
    expectOptionsAreMade(electricityKnob);
}

TEST_F(ElectricityKnob, OptionsHaveNoErrorAndTheirWorkIncreasesWithTheLevel) {
    open("2-doorbell.json");
    runTo(2);
    auto const knob = electricityKnob(world());
    ASSERT_TRUE(knob);
    for (Option const& option : knob->options) {
        EXPECT_EQ(option.error.metres, 0) << option.name;
        EXPECT_GT(option.work, 0) << option.name;
    }
    EXPECT_GT(named(*knob, "nodal").work, named(*knob, "two-wire").work);
    EXPECT_GT(named(*knob, "two-wire").work, named(*knob, "single-cable").work);
}

TEST_F(ElectricityKnob, WithoutConductorsThereIsNone) {
    open(levelOf(R"("world": {}, "objects": [])"));
    runTo(1);
    EXPECT_FALSE(electricityKnob(world()));
}

} // namespace
} // namespace electricity_knob_test
} // namespace trembler::budget
