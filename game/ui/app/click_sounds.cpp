#include "game/ui/app/click_sounds.hpp"

#include "audio/device/loudspeaker.hpp"

#include <imgui_internal.h>

#include <utility>

namespace trembler::ui {
namespace {

/// Whether the mouse was let go over the widget on which it was pressed.
bool clickedAWidget(render::InputEvents const& input) {
    ImGuiContext const& gui = *ImGui::GetCurrentContext();
    return input.released(render::MouseButton::Left) && gui.ActiveIdPreviousFrame != 0 && gui.ActiveId == 0 &&
           gui.HoveredId == gui.ActiveIdPreviousFrame;
}

} // namespace

void ClickSounds::look(UiContext const& context) {
    Loudspeaker* const loudspeaker = context.loudspeaker;
    if (loudspeaker == nullptr) {
        return;
    }
    std::uint64_t const before = touched_;
    bool const ownSound = loudspeaker->touched() != before;
    if (context.input.pressed(render::MouseButton::Left)) {
        atPress_ = before;
    }
    bool const refused = context.toasts.troubles() > std::exchange(troubles_, context.toasts.troubles());
    bool const clicked = clickedAWidget(context.input) && loudspeaker->touched() == atPress_;
    if (refused && !ownSound) {
        loudspeaker->touch(InterfaceSound::refuse);
    } else if (clicked || (context.focus.pressed() && !ownSound)) {
        loudspeaker->touch(InterfaceSound::click);
    }
    touched_ = loudspeaker->touched();
}

} // namespace trembler::ui
