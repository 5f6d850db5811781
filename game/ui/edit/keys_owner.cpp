#include "game/ui/edit/keys_owner.hpp"

#include <imgui_internal.h>

namespace trembler::ui {

bool KeysOwner::popup() {
    return ImGui::GetCurrentContext()->OpenPopupStack.Size > 0;
}

void KeysOwner::look(bool carrying) {
    before_ = now_;
    // ImGui reports a field that takes text from its second picture on; it is active from the first.
    now_ = popup() || ImGui::GetIO().WantTextInput || (ImGui::IsAnyItemActive() && !carrying);
}

} // namespace trembler::ui
