// A screen with every kind of panel, drawn at two sizes, for people to look at.
#include "render/draw/path.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/cards.hpp"
#include "render/panels/toasts.hpp"
#include "render/panels/toolbox_tile.hpp"
#include "render/panels/world_label.hpp"
#include "tests/render/panels/panels.hpp"
#include "tests/support/sanitizer.hpp"

#include <imgui_stdlib.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace trembler::render::test {
namespace {

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
