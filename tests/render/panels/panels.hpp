// A window with panels, for tests of them.
#pragma once

#include "render/panels/gui.hpp"
#include "tests/render/stage.hpp"
#include "tests/support/synthetic_input.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <memory>

namespace trembler::render::test {

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

} // namespace trembler::render::test
