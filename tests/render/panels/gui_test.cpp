// Panels react to SDL's events, including pushed ones, and are drawn correctly at both sizes.
#include "render/draw/path.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/cards.hpp"
#include "render/panels/gui.hpp"
#include "render/panels/toasts.hpp"
#include "render/panels/toolbox_tile.hpp"
#include "render/panels/world_label.hpp"
#include "render/window/synthetic_input.hpp"
#include "tests/render/stage.hpp"
#include "tests/support/sanitizer.hpp"

#include <epoxy/gl.h>
#include <imgui_stdlib.h>

#include <functional>
#include <memory>

namespace trembler::render::test {
namespace {

class Panels : public testing::Test {
protected:
    void SetUp() override {
        SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);
        window().resize({1280, 720});
        gui_ = std::make_unique<Gui>(window(), GuiOptions{.steady = true});
        input_ = std::make_unique<InputEvents>(window());
    }

    /// One frame of `draw`, on the paper.
    void frame(std::function<void()> const& draw) {
        input_->poll();
        gui_->beginFrame(*input_, 1.0 / 60);
        draw();
        window().beginFrame(palette::paper);
        gui_->endFrame();
        window().present();
    }

    /// One frame of `draw` that is not drawn.
    void dropped(std::function<void()> const& draw) {
        input_->poll();
        gui_->beginFrame(*input_, 1.0 / 60);
        draw();
        gui_->dropFrame();
    }

    std::unique_ptr<Gui> gui_;
    std::unique_ptr<InputEvents> input_;
};

/// A window at a fixed place with one item, whose middle is stored.
struct Bench {
    ImVec2 middle;
    void show(std::function<void()> const& draw) {
        ImGui::SetNextWindowPos({100, 100});
        ImGui::Begin("bench", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize);
        draw();
        ImVec2 const low = ImGui::GetItemRectMin();
        ImVec2 const high = ImGui::GetItemRectMax();
        middle = {0.5F * (low.x + high.x), 0.5F * (low.y + high.y)};
        ImGui::End();
    }
    [[nodiscard]] Point at() const { return {static_cast<double>(middle.x), static_cast<double>(middle.y)}; }
};

// Keys are named in body text and, on the page of keys, in small text. Both come from a font that lacks
// arrows.
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

TEST_F(Panels, AClickWithinOneFrameClicks) {
    Bench bench;
    int clicks = 0;
    auto const draw = [&] { bench.show([&] { clicks += bigButton("Start") ? 1 : 0; }); };
    frame(draw);
    frame(draw);
    pushMouseMove(window(), bench.at());
    frame(draw);
    pushClick(window(), bench.at());
    frame(draw);
    frame(draw);
    frame(draw);
    EXPECT_EQ(clicks, 1);
    // A click beside the button is ignored by panels and left to the world.
    pushClick(window(), {900, 600});
    frame(draw);
    frame(draw);
    EXPECT_EQ(clicks, 1);
    EXPECT_FALSE(gui_->wantsMouse());
}

TEST_F(Panels, ADisabledButtonCannotBeClicked) {
    Bench bench;
    int clicks = 0;
    auto const draw = [&] { bench.show([&] { clicks += bigButton("Start", {.enabled = false}) ? 1 : 0; }); };
    frame(draw);
    frame(draw);
    pushClick(window(), bench.at());
    frame(draw);
    frame(draw);
    EXPECT_EQ(clicks, 0);
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

TEST_F(Panels, ATileIsTakenWhenTheMouseGoesDown) {
    Bench bench;
    int taken = 0;
    int count = 1;
    auto const draw = [&] {
        bench.show(
            [&] { taken += toolboxTile({.id = "bar", .name = "Steel bar", .count = count}).taken ? 1 : 0; });
    };
    frame(draw);
    frame(draw);
    pushMouseMove(window(), bench.at());
    frame(draw);
    pushMouseButton(window(), MouseButton::Left, true, bench.at());
    frame(draw);
    EXPECT_EQ(taken, 1);
    pushMouseButton(window(), MouseButton::Left, false, bench.at());
    frame(draw);
    count = 0;
    pushClick(window(), bench.at());
    frame(draw);
    frame(draw);
    EXPECT_EQ(taken, 1);
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
    EXPECT_FALSE(input_->quit());
    pushKey(window(), SDLK_SPACE, false);
    pushMouseButton(window(), MouseButton::Right, false, {13, 18});
    pushQuit();
    frame(nothing);
    EXPECT_FALSE(input_->keyHeld(SDLK_SPACE));
    EXPECT_TRUE(input_->released(MouseButton::Right));
    EXPECT_TRUE(input_->quit());
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

TEST_F(Panels, ToastsAppearAndDisappear) {
    Toasts toasts;
    for (int i = 0; i < 8; ++i) {
        toasts.add("Number " + std::to_string(i), ToastKind::News, 1);
    }
    EXPECT_EQ(toasts.count(), 5U);
    frame([&] { toasts.draw(0.5); });
    EXPECT_EQ(toasts.count(), 5U);
    frame([&] { toasts.draw(0.6); });
    EXPECT_EQ(toasts.count(), 0U);
}

/// A part's small picture, as a toolbox shows it.
std::unique_ptr<Framebuffer> partPicture(float scale, std::function<void(Canvas&)> const& draw) {
    auto const side = static_cast<int>(80 * scale);
    auto target = std::make_unique<Framebuffer>(Size{side, side});
    target->bind();
    clearBound(tileGround());
    Camera camera{{0, 0}, 0.42 * side, {side, side}};
    canvas().begin(camera, {.uiScale = scale});
    draw(canvas());
    canvas().end();
    return target;
}

void sampleWorld(Canvas& sheet) {
    sheet.paper();
    sheet.box({{0, -2.6}, 0}, {5.2, 0.25}, 0.03, {.pattern = Pattern::Wood});
    sheet.box({{-2.2, -1.75}, 0}, {0.8, 0.6}, 0.06, {.pattern = Pattern::Metal});
    sheet.box({{-2.2, 0.1}, 0}, {0.35, 1.25}, 0.04, {.pattern = Pattern::Metal});
    for (int i = 0; i < 9; ++i) {
        double const y = -0.9 + 0.22 * i;
        sheet.capsule({-2.62, y}, {-1.78, y + 0.1}, 0.085, {.pattern = Pattern::Copper, .outline = 1.4F});
    }
    Stroke wire{.colour = palette::live, .width = 0.09, .outline = 1.5F, .round = true, .height = 1.F};
    wire.glow = {palette::live, 0.22, 0.8F};
    auto const live = hangingWire({-1.75, -0.8}, {1.6, -1.9}, 0.5, 24);
    sheet.polyline(live, wire);
    sheet.beads(live, 0.28, 0.3, 0.03, palette::liveCore);
    sheet.box({{2.1, -2.05}, 0}, {0.55, 0.3}, 0.05,
              {.pattern = Pattern::Plastic, .glow = {palette::live, 0.2, 0.7F}});
    sheet.newSheet();
    Style bar{.pattern = Pattern::Metal};
    bar.selected = true;
    sheet.box({{-2.1, 2.2}, 0.12}, {0.9, 0.13}, 0.04, bar);
    sheet.arrow({-2.1, 2.0}, {-2.1, 1.55}, {.colour = palette::force, .pixels = 5.F, .outline = 1.2F});
    sheet.circle({{3.4, -1.9}, 0.4}, 0.45, {.pattern = Pattern::Rubber});
}

TEST_F(Panels, SampleScreen) {
    std::vector<Size> sizes{{1280, 720}};
    if (!trembler::test::underSanitizer) { // both sizes are drawn by the same code
        sizes.push_back({3840, 2160});
    }
    for (Size const size : sizes) {
        window().resize(size);
        float const scale = window().uiScale();
        std::array const pictures{
            partPicture(scale,
                        [](Canvas& c) {
                            c.box({{0, 0}, 0.5}, {0.9, 0.14}, 0.03, {.pattern = Pattern::Metal});
                        }),
            partPicture(scale,
                        [](Canvas& c) {
                            c.box({{0, 0}, 0.5}, {0.9, 0.14}, 0.03, {.pattern = Pattern::Wood});
                        }),
            partPicture(scale,
                        [](Canvas& c) {
                            c.circle({{0, 0}, 0.5}, 0.6, {.pattern = Pattern::Rubber});
                        }),
            partPicture(scale,
                        [](Canvas& c) {
                            c.circle({{0, 0}, 0.5}, 0.6, {.pattern = Pattern::Glass});
                        }),
        };
        Toasts toasts;
        toasts.add("The bar closes the circuit", ToastKind::Success);
        Camera camera;
        camera.viewport = size;
        camera.fit({-6.4, -3.6}, {6.4, 3.6}, 0);
        Image image;
        for (int i = 0; i < 4; ++i) {
            input_->poll();
            gui_->beginFrame(*input_, 1.0 / 60);
            window().beginFrame(palette::paper);
            canvas().begin(camera, {.uiScale = scale});
            sampleWorld(canvas());
            canvas().end();
            worldLabel(camera, {2.1, -2.05}, "battery", {.look = LabelLook::Chip, .below = 42.F});
            worldLabel(camera, {-2.2, -1.75}, "N", {.colour = palette::paperLight, .metresHigh = 0.5});
            worldLabel(camera, {-1.6, 1.7}, "12 N", {.colour = palette::force});

            beginCard("goal", "First contact", {.anchor = Anchor::TopLeft, .width = 320});
            std::array const goals{
                GoalLine{"Lift the steel bar off the table", GoalLine::State::Met},
                GoalLine{"Keep the magnet on for two seconds", GoalLine::State::Open, 0.6F},
                GoalLine{"Leave the glass ball whole", GoalLine::State::Failed},
            };
            goalLines(goals);
            caption("Take a part from the toolbox and put it where current should flow.");
            endCard();

            beginCard("toolbox", "Toolbox", {.anchor = Anchor::TopRight});
            std::array const names{"Steel bar", "Wooden bar", "Rubber ball", "Glass ball"};
            for (int tile = 0; tile < 4; ++tile) {
                auto const index = static_cast<std::size_t>(tile);
                if (tile % 2 == 1) {
                    ImGui::SameLine();
                }
                toolboxTile({.id = names[index],
                             .name = names[index],
                             .count = 3 - tile,
                             .picture = pictures[index]->texture(),
                             .selected = tile == 0});
            }
            endCard();

            beginCard("transport", "", {.anchor = Anchor::Bottom, .bare = true});
            bigButton("Start", {.icon = Icon::Play, .look = ButtonLook::Primary, .width = 150});
            ImGui::SameLine();
            bigButton("Reset", {.icon = Icon::Reset});
            ImGui::SameLine();
            bigButton("Give up", {.icon = Icon::Cross, .look = ButtonLook::Danger});
            ImGui::SameLine();
            bigButton("Later", {.enabled = false});
            endCard();

            beginCard("tools", "", {.anchor = Anchor::BottomLeft, .width = 330});
            std::array const icons{
                Icon::Play,   Icon::Pause,    Icon::Stop,      Icon::Step,   Icon::Record, Icon::Reset,
                Icon::Camera, Icon::TurnLeft, Icon::TurnRight, Icon::Flip,   Icon::Remove, Icon::Hint,
                Icon::Why,    Icon::Menu,     Icon::Settings,  Icon::Back,   Icon::Next,   Icon::Tick,
                Icon::Cross,  Icon::Plus,     Icon::Eye,       Icon::Magnet, Icon::Bolt};
            for (std::size_t n = 0; n < icons.size(); ++n) {
                if (n % 6 != 0) {
                    ImGui::SameLine();
                }
                iconButton(("icon" + std::to_string(n)).c_str(), icons[n], "", n == 20);
            }
            endCard();

            beginCard("inspector", "Inspector", {.anchor = Anchor::BottomRight, .width = 290});
            static float mass = 2.5F;
            static bool fixed = true;
            static std::string name = "object 1";
            ImGui::InputText("Name", &name);
            ImGui::SliderFloat("Mass", &mass, 0.F, 10.F, "%.1f kg");
            ImGui::Checkbox("Fixed in place", &fixed);
            ImGui::TextUnformatted("Resistance  4.7 Ω → 12 V");
            endCard();
            toasts.draw(0.2);
            gui_->endFrame();
            image = window().readPixels();
            window().present();
        }
        keepForPeople(image, "panels-" + std::to_string(size.height));
        EXPECT_EQ(image.size(), size);
    }
}

} // namespace
} // namespace trembler::render::test
