// Panels react to SDL's events, including pushed ones, and are drawn correctly at both sizes.
#include "render/panels/gui.hpp"
#include "render/panels/theme.hpp"
#include "tests/render/panels/panels.hpp"

#include <epoxy/gl.h>
#include <imgui_stdlib.h>

#include <functional>
#include <memory>

namespace trembler::render::test {
namespace {

/// How many textures the graphics card has.
int textures() {
    unsigned const newest = makeTexture().name();
    int all = 0;
    for (unsigned name = 1; name <= newest; ++name) {
        all += glIsTexture(name) == GL_TRUE ? 1 : 0;
    }
    return all;
}

TEST_F(Panels, FollowTheScaleBeforeTheirFirstFrameWithoutATextureTooMany) {
    frame([] {});
    gui_.reset();
    int const before = textures();
    gui_ = std::make_unique<Gui>(window(), GuiOptions{.steady = true});
    float const scale = window().uiScale();
    window().resize({2560, 1440});
    ASSERT_NE(window().uiScale(), scale);
    frame([] {});
    window().resize({1280, 720});
    frame([] {});
    EXPECT_EQ(textures(), before + 1); // the letters
    gui_.reset();
    EXPECT_EQ(textures(), before);
}

// Keys are named in body text and, on the page of keys, in small text. Both come from a font that lacks
// arrows.
TEST_F(Panels, TextOfBothSizesHasTheArrowKeys) {
    if (theme().fonts.builtIn) {
        GTEST_SKIP() << "no font is installed";
    }
    for (ImFont const* const font : {theme().fonts.body, theme().fonts.small}) {
        for (ImWchar arrow = 0x2190; arrow <= 0x2193; ++arrow) {
            EXPECT_NE(font->FindGlyphNoFallback(arrow), nullptr) << std::hex << arrow;
        }
    }
}

TEST_F(Panels, TextOfBothSizesHasTheSpaceBetweenGroupsOfDigits) {
    if (theme().fonts.builtIn) {
        GTEST_SKIP() << "no font is installed";
    }
    for (ImFont const* const font : {theme().fonts.body, theme().fonts.small}) {
        EXPECT_NE(font->FindGlyphNoFallback(0x2009), nullptr);
    }
}

TEST_F(Panels, ADroppedFrameDrawsNothingButHandlesInput) {
    Bench bench;
    int clicks = 0;
    auto const draw = [&] { bench.show([&] { clicks += ImGui::Button("Press me") ? 1 : 0; }); };
    window().beginFrame(palette::paper);
    Image const blank = window().readPixels();
    for (int i = 0; i < 3; ++i) {
        dropped(draw);
    }
    pushMouseMove(window(), bench.at());
    dropped(draw);
    pushMouseButton(window(), MouseButton::Left, true, bench.at());
    dropped(draw);
    pushMouseButton(window(), MouseButton::Left, false, bench.at());
    dropped(draw);
    EXPECT_EQ(clicks, 1);
    EXPECT_EQ(window().readPixels(), blank);
    frame(draw);
    Image const drawn = window().readPixels();
    EXPECT_NE(drawn, blank);
    frame(draw);
    EXPECT_EQ(window().readPixels(), drawn) << "the first picture after the dropped ones is complete";
}

TEST_F(Panels, APushedClickClicks) {
    Bench bench;
    int clicks = 0;
    auto const draw = [&] { bench.show([&] { clicks += ImGui::Button("Press me") ? 1 : 0; }); };
    frame(draw);
    frame(draw);
    pushMouseMove(window(), bench.at());
    frame(draw);
    pushMouseButton(window(), MouseButton::Left, true, bench.at());
    frame(draw);
    EXPECT_TRUE(gui_->wantsMouse());
    EXPECT_EQ(clicks, 0);
    pushMouseButton(window(), MouseButton::Left, false, bench.at());
    frame(draw);
    frame(draw);
    EXPECT_EQ(clicks, 1);
}

TEST_F(Panels, DragsMoveSliders) {
    Bench bench;
    float value = 0.F;
    auto const draw = [&] {
        bench.show([&] {
            ImGui::SetNextItemWidth(300);
            ImGui::SliderFloat("##value", &value, 0.F, 1.F);
        });
    };
    frame(draw);
    frame(draw);
    pushMouseMove(window(), bench.at());
    frame(draw);
    pushMouseButton(window(), MouseButton::Left, true, bench.at());
    frame(draw);
    pushMouseMove(window(), bench.at() + Point{100, 0});
    frame(draw);
    EXPECT_GT(value, 0.7F);
    pushMouseButton(window(), MouseButton::Left, false, bench.at() + Point{100, 0});
    frame(draw);
    pushMouseMove(window(), bench.at());
    frame(draw);
    EXPECT_GT(value, 0.7F);
}

TEST_F(Panels, TextIsTyped) {
    Bench bench;
    std::string text;
    auto const draw = [&] { bench.show([&] { ImGui::InputText("##text", &text); }); };
    frame(draw);
    frame(draw);
    pushClick(window(), bench.at());
    frame(draw);
    frame(draw);
    EXPECT_TRUE(gui_->wantsKeyboard());
    pushText(window(), "Trembler läuft und läuft und läuft, 3 Ω");
    frame(draw);
    frame(draw);
    EXPECT_EQ(text, "Trembler läuft und läuft und läuft, 3 Ω");
    pushKey(window(), SDLK_BACKSPACE, true);
    frame(draw);
    pushKey(window(), SDLK_BACKSPACE, false);
    frame(draw);
    EXPECT_EQ(text, "Trembler läuft und läuft und läuft, 3 ");
    pushKey(window(), SDLK_a, true, KMOD_LCTRL);
    frame(draw);
    pushKey(window(), SDLK_a, false, KMOD_NONE);
    pushKey(window(), SDLK_DELETE, true);
    frame(draw);
    frame(draw);
    EXPECT_EQ(text, "");
}

TEST_F(Panels, InputReportsTheEvents) {
    auto const nothing = [] {};
    frame(nothing);
    pushMouseMove(window(), {10, 20});
    frame(nothing);
    pushMouseMove(window(), {13, 18});
    pushWheel(window(), 2);
    pushKey(window(), SDLK_SPACE, true);
    pushMouseButton(window(), MouseButton::Right, true, {13, 18}, 2);
    frame(nothing);
    EXPECT_EQ(input_->mouse(), (Point{13, 18}));
    EXPECT_EQ(input_->mouseMoved(), (Point{3, -2}));
    EXPECT_EQ(input_->wheel(), 2);
    EXPECT_TRUE(input_->keyPressed(SDLK_SPACE));
    EXPECT_TRUE(input_->pressed(MouseButton::Right));
    EXPECT_TRUE(input_->doubleClicked(MouseButton::Right));
    frame(nothing);
    EXPECT_FALSE(input_->keyPressed(SDLK_SPACE));
    EXPECT_TRUE(input_->keyHeld(SDLK_SPACE));
    EXPECT_TRUE(input_->held(MouseButton::Right));
    EXPECT_FALSE(input_->pressed(MouseButton::Right));
    EXPECT_FALSE(input_->quitAsked());
    pushKey(window(), SDLK_SPACE, false);
    pushMouseButton(window(), MouseButton::Right, false, {13, 18});
    pushQuit();
    frame(nothing);
    EXPECT_FALSE(input_->keyHeld(SDLK_SPACE));
    EXPECT_TRUE(input_->released(MouseButton::Right));
    EXPECT_TRUE(input_->quitAsked());
}

TEST_F(Panels, LettersScaleWithTheInterface) {
    frame([] {});
    float const small = gui_->fonts().body->FontSize;
    EXPECT_FALSE(gui_->fonts().message.empty());
    window().resize({3840, 2160});
    frame([] {});
    EXPECT_NEAR(gui_->fonts().body->FontSize / small, window().uiScale(), 0.05);
    EXPECT_FALSE(gui_->fonts().builtIn) << gui_->fonts().message;
    for (ImWchar const sign : std::initializer_list<ImWchar>{0x03A9, 0x00B5, 0x2192, 0x2713, 0x2026}) {
        EXPECT_NE(gui_->fonts().body->FindGlyphNoFallback(sign), nullptr) << std::hex << sign;
    }
}

} // namespace
} // namespace trembler::render::test
