// The changes that are allowed while a world runs: numbers within their range of accuracy, periods up to the
// longest, and detail levels that compute the same physics.
#include "runtime/level/model/change_fault.hpp"
#include "tests/runtime/level/model/bakery.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace trembler {
namespace change_fault_test {
namespace {

using namespace bakery;

bool isTaken(RecordedChange const& change) {
    return !faultIn(bakeryRegistry(), change).has_value();
}

/// Of a change that must be refused: the message and what is expected instead.
std::string refusalOf(RecordedChange const& change) {
    auto const fault = faultIn(bakeryRegistry(), change);
    return fault ? inWords(*fault) : "(taken)";
}

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

TEST(ChangeFault, ASettingIsTakenWithinItsRangeOfAccuracy) {
    for (double const layers : {0.0, 1.0, 2.0, 16.0}) {
        EXPECT_TRUE(isTaken(settingTo("oven", "layers", layers))) << layers;
    }
    for (double const layers : {-1.0, 0.5, 1.5, 17.0, 64.0, 1e300, infinite, -infinite, notANumber}) {
        EXPECT_FALSE(isTaken(settingTo("oven", "layers", layers))) << layers;
    }
    for (double const tolerance : {1e-9, 0.5, 1.0}) {
        EXPECT_TRUE(isTaken(settingTo("oven", "tolerance", tolerance))) << tolerance;
    }
    // 0 is in the range of accuracy, but the field excludes it; 2 is physics.
    for (double const tolerance : {0.0, -0.5, 1.001, 2.0, infinite, notANumber}) {
        EXPECT_FALSE(isTaken(settingTo("oven", "tolerance", tolerance))) << tolerance;
    }
    EXPECT_TRUE(rc::check("random settings", [] {
        double const quarters =
            *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(-40, 120)) / 4.0; // from -10 to 29.75
        bool const whole = std::floor(quarters) == quarters;
        RC_ASSERT(isTaken(settingTo("oven", "layers", quarters)) ==
                  (whole && quarters >= 0 && quarters <= 16));
        RC_ASSERT(isTaken(settingTo("oven", "tolerance", quarters)) == (quarters > 0 && quarters <= 1));
        RC_ASSERT(!isTaken(settingTo("oven", "heat", quarters)));
    }));
}

TEST(ChangeFault, ARefusedSettingIsNamedWithThoseThatThereAre) {
    for (RecordedChange const& change :
         {settingTo("ovn", "layers", 2), settingTo("dough", "value", 2), settingTo("oven", "layer", 2),
          settingTo("oven", "fan", 1), settingTo("oven", "heat", 180)}) {
        std::string const said = refusalOf(change);
        EXPECT_NE(said.find("oven.layers (0, or 1 to 16)"), std::string::npos) << said;
        EXPECT_NE(said.find("oven.tolerance (0 to 1)"), std::string::npos) << said;
        EXPECT_EQ(said.find("oven.heat"), std::string::npos) << "not permitted: " << said;
        EXPECT_EQ(said.find("oven.fan"), std::string::npos) << "not permitted: " << said;
    }
    EXPECT_NE(refusalOf(settingTo("ovn", "layers", 2)).find("'ovn'"), std::string::npos);
    EXPECT_NE(refusalOf(settingTo("oven", "layer", 2)).find("'layer'"), std::string::npos);
    EXPECT_NE(refusalOf(settingTo("oven", "heat", 180)).find("physics"), std::string::npos);
    std::string const tooMany = refusalOf(settingTo("oven", "layers", 17));
    for (char const* const part : {"17", "0, or", "from 1 to 16", "whole"}) {
        EXPECT_NE(tooMany.find(part), std::string::npos) << tooMany;
    }
    EXPECT_EQ(refusalOf(settingTo("oven", "tolerance", 2)).find("whole"), std::string::npos);
}

TEST(ChangeFault, APeriodIsTakenUpToTheLongest) {
    EXPECT_TRUE(rc::check("random periods", [] {
        double const period =
            *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(-4, 16)) / 2.0; // from -2 to 7.5
        RC_ASSERT(isTaken(periodTo("Exact Baking DPS", period)) ==
                  (period == 1 || period == 2 || period == 3 || period == 4));
        RC_ASSERT(isTaken(periodTo("Rough Baking DPS", period)) == (period == 1));
        RC_ASSERT(isTaken(periodTo("Timer DPS", period)) == (period == 3));
    }));
    for (double const nonsense : {infinite, -infinite, notANumber}) {
        EXPECT_FALSE(isTaken(periodTo("Exact Baking DPS", nonsense))) << nonsense;
    }
    // Files state full titles; a bare name may belong to several components.
    for (char const* const unknown : {"Exact Baking", "exact baking DPS", "Baking DPS", ""}) {
        std::string const said = refusalOf(periodTo(unknown, 2));
        EXPECT_NE(said.find("Exact Baking DPS (1 to 4)"), std::string::npos) << said;
        EXPECT_EQ(said.find("Timer DPS"), std::string::npos) << said;
    }
}

TEST(ChangeFault, ADetailLevelMustExistInTheProgram) {
    for (char const* const level : {"", "exact", "rough"}) {
        EXPECT_TRUE(isTaken(detailTo("baking", level))) << level;
    }
    EXPECT_NE(refusalOf(detailTo("baking", "laboratory")).find("there is no laboratory"), std::string::npos);
    std::string const level = refusalOf(detailTo("baking", "exakt"));
    for (char const* const part : {"'exakt'", "exact", "rough"}) {
        EXPECT_NE(level.find(part), std::string::npos) << level;
    }
    for (char const* const effect : {"timer", "frying", ""}) { // the timer has one level only
        std::string const said = refusalOf(detailTo(effect, ""));
        EXPECT_NE(said.find("expected one of the effects: baking"), std::string::npos) << said;
    }
}

// The content of the scene decides whether two levels differ in accuracy only.
TEST(ChangeFault, ADetailLevelMustComputeTheSamePhysics) {
    struct Case {
        bool souffle;
        std::string stated; // by the level file; "" if it states no level
        std::map<std::string, bool> taken;
    };
    std::map<std::string, bool> const all{{"", true}, {"exact", true}, {"rough", true}};
    std::map<std::string, bool> const notRough{{"", true}, {"exact", true}, {"rough", false}};
    std::map<std::string, bool> const roughOnly{{"", false}, {"exact", false}, {"rough", true}};
    for (Case const& c : std::vector<Case>{{false, "", all},
                                           {false, "exact", all},
                                           {false, "rough", all},
                                           {true, "", notRough},
                                           {true, "exact", notRough},
                                           {true, "rough", roughOnly}}) {
        std::map<std::string, std::string> stated;
        if (!c.stated.empty()) {
            stated["baking"] = c.stated;
        }
        WorldOptions options;
        options.detail = stated;
        Bakery const asStated(options, c.souffle);
        Bakery const other({}, c.souffle);
        for (auto const& [level, taken] : c.taken) {
            RecordedChange const change = detailTo("baking", level);
            EXPECT_EQ(!faultIn(bakeryRegistry(), asStated.world, change), taken)
                << c.souffle << " " << c.stated << " " << level;
            EXPECT_EQ(!faultIn(bakeryRegistry(), other.world, stated, change), taken)
                << "stated apart from the world: " << c.souffle << " " << c.stated << " " << level;
        }
    }
    Bakery const bakery({}, true);
    auto const fault = faultIn(bakeryRegistry(), bakery.world, detailTo("baking", "rough"));
    ASSERT_TRUE(fault);
    EXPECT_NE(fault->message.find("rough"), std::string::npos) << fault->message;
    EXPECT_NE(fault->expected.find("'exact'"), std::string::npos) << fault->expected;
    EXPECT_EQ(fault->expected.find("'rough'"), std::string::npos) << fault->expected;
}

TEST(ChangeFault, InAWorldOtherFaultsAreTheSame) {
    Bakery const bakery;
    for (RecordedChange const& change :
         {settingTo("oven", "layers", 17), settingTo("oven", "layers", 16), periodTo("Timer DPS", 1),
          periodTo("Exact Baking DPS", 4), detailTo("baking", "laboratory"), detailTo("frying", "")}) {
        auto const here = faultIn(bakeryRegistry(), bakery.world, change);
        auto const anywhere = faultIn(bakeryRegistry(), change);
        ASSERT_EQ(here.has_value(), anywhere.has_value()) << change.subject;
        if (here) {
            EXPECT_EQ(inWords(*here), inWords(*anywhere));
        }
    }
}

} // namespace
} // namespace change_fault_test
} // namespace trembler
