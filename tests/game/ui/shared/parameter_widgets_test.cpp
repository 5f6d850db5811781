#include "game/ui/shared/parameter_widgets.hpp"
#include "lua/attach/parameter_value.hpp"
#include "render/panels/gui.hpp"
#include "tests/game/ui/player.hpp"

#include <utility>

namespace trembler::ui::test {
namespace {

/// One widget on a card, used like a player does.
struct OneWidget {
    explicit OneWidget(lua::Parameter made) : parameter(std::move(made)), value(parameter.initial) {
        SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);
        window().resize({640, 360});
        frames(3);
    }
    void frame() {
        input.poll();
        gui.beginFrame(input, 1.0 / 60);
        layout.beginFrame();
        layout.beginCard("card", "", {.width = 300});
        if (auto const changed = parameterWidget(layout, parameter, value, "widget")) {
            value = *changed;
            EXPECT_FALSE(lua::faultOf(parameter, value)) << *lua::faultOf(parameter, value);
        }
        layout.endCard();
        gui.dropFrame();
    }
    void frames(int count) {
        for (int i = 0; i < count; ++i) {
            frame();
        }
    }
    /// Presses in the widget, so far from its left, 0 to 1.
    void clickAt(double share) {
        auto const rect = std::as_const(layout).item("widget");
        ASSERT_TRUE(rect);
        Point const at{rect->low.x + share * (rect->high.x - rect->low.x), rect->middle().y};
        render::pushMouseMove(window(), at);
        frame();
        render::pushMouseButton(window(), MouseButton::Left, true, at);
        frame();
        render::pushMouseButton(window(), MouseButton::Left, false, at);
        frames(2);
    }

    lua::Parameter parameter;
    lua::Value value;
    render::Gui gui{window(), {.steady = true}};
    render::InputEvents input{window()};
    Layout layout;
};

TEST(ParameterWidgets, ANumberWithARangeIsASliderFromEndToEnd) {
    OneWidget widget(
        {.name = "speed", .initial = 8.0, .minimum = 0, .maximum = 60, .unit = "m/s", .text = ""});
    widget.clickAt(0.99);
    EXPECT_EQ(widget.value, lua::Value(60.0));
    widget.clickAt(0.01);
    EXPECT_EQ(widget.value, lua::Value(0.0));
    widget.clickAt(0.5);
    EXPECT_NEAR(std::get<double>(widget.value), 30, 2);
}

TEST(ParameterWidgets, ASliderOverManyPowersOfTenIsFineAtItsLowEnd) {
    OneWidget widget(
        {.name = "reach", .initial = 8.0, .minimum = 0, .maximum = 1e4, .unit = "m", .text = ""});
    widget.clickAt(0.5);
    EXPECT_LT(std::get<double>(widget.value), 500);
    widget.clickAt(0.99);
    EXPECT_EQ(widget.value, lua::Value(1e4));
}

TEST(ParameterWidgets, AnUnitWithAPerCentSignIsShownAsItIs) {
    OneWidget widget(
        {.name = "share", .initial = 50.0, .minimum = 0, .maximum = 100, .unit = "%n%s", .text = ""});
    widget.clickAt(0.99); // a format that ImGui took for its own would read where nothing is
    EXPECT_EQ(widget.value, lua::Value(100.0));
}

TEST(ParameterWidgets, TrueOrFalseIsATickBox) {
    OneWidget widget({.name = "left", .initial = false, .unit = "", .text = ""});
    widget.clickAt(0.5);
    EXPECT_EQ(widget.value, lua::Value(true));
}

TEST(ParameterWidgets, NamesAndValuesAreReportedInWords) {
    EXPECT_EQ(spokenName("half_angle"), "half angle");
    EXPECT_EQ(valueInWords(12.0), "12");
    EXPECT_EQ(valueInWords(true), "yes");
    EXPECT_EQ(valueInWords(Vec2{1, -0.5}), "1, -0.5");
    EXPECT_EQ(valueInWords(std::string("red")), "red");
}

} // namespace
} // namespace trembler::ui::test
