#include "lua/attach/parameter_value.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace trembler::lua {
namespace {

Parameter const aNumber{.name = "n", .initial = 1.0, .minimum = 0, .maximum = 2, .unit = "m", .text = ""};
Parameter const aColour{
    .name = "c", .initial = std::string("red"), .unit = "", .text = "", .choices = {"red", "blue"}};
Parameter const aWord{.name = "w", .initial = std::string("any"), .unit = "", .text = ""};
Parameter const aFlag{.name = "f", .initial = false, .unit = "", .text = ""};
Parameter const aWay{.name = "v", .initial = Vec2{1, 0}, .unit = "", .text = ""};

TEST(ParameterValue, IsOfItsKindInItsRangeAndOneOfItsChoices) {
    for (auto const& [parameter, good] :
         std::vector<std::pair<Parameter const*, Value>>{{&aNumber, 0.0},
                                                         {&aNumber, 2.0},
                                                         {&aColour, std::string("blue")},
                                                         {&aWord, std::string()},
                                                         {&aFlag, true},
                                                         {&aWay, Vec2{-1e200, 0}}}) {
        EXPECT_EQ(faultOf(*parameter, good), std::nullopt) << parameter->name;
    }
    double const infinite = std::numeric_limits<double>::infinity();
    for (auto const& [parameter, bad] :
         std::vector<std::pair<Parameter const*, Value>>{{&aNumber, -0.1},
                                                         {&aNumber, 2.1},
                                                         {&aNumber, infinite},
                                                         {&aNumber, std::nan("")},
                                                         {&aNumber, true},
                                                         {&aColour, std::string("green")},
                                                         {&aWord, std::string(longestText + 1, 'x')},
                                                         {&aFlag, 1.0},
                                                         {&aWay, Vec2{infinite, 0}}}) {
        EXPECT_TRUE(faultOf(*parameter, bad)) << parameter->name;
    }
}

TEST(ParameterValue, SettingsStateWhatTheyWereMadeOf) {
    for (auto const& [parameter, value] : std::vector<std::pair<Parameter const*, Value>>{
             {&aNumber, 1.5}, {&aColour, std::string("blue")}, {&aFlag, true}, {&aWay, Vec2{3, -4}}}) {
        ScriptSetting const setting = settingOf(parameter->name, value);
        EXPECT_EQ(setting.parameter, parameter->name);
        EXPECT_EQ(valueOf(setting, *parameter), value);
        ScriptUse const use{"script", {setting}};
        EXPECT_EQ(valueFor(&use, *parameter), value);
        EXPECT_EQ(valueFor(nullptr, *parameter), parameter->initial);
        EXPECT_EQ(valueFor(&use, aWord), aWord.initial) << "it does not state that one";
    }
}

} // namespace
} // namespace trembler::lua
