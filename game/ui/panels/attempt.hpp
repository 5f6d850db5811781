// Changes of a running world that may fail.
#pragma once

#include "game/ui/shared/texts.hpp"
#include "render/panels/toasts.hpp"

#include <stdexcept>

namespace trembler::ui {

/// Calls change(); if it throws std::invalid_argument or std::runtime_error, shows the player the message.
template <class F>
void attempt(render::Toasts& toasts, F&& change) {
    try {
        change();
    } catch (std::invalid_argument const& error) {
        toasts.add(translated(error.what()), render::ToastKind::Trouble);
    } catch (std::runtime_error const& error) {
        toasts.add(translated(error.what()), render::ToastKind::Trouble);
    }
}

} // namespace trembler::ui
