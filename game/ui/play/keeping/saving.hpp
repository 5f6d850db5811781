// Saving what the player placed and did as a solution file.
#pragma once

#include "game/ui/shared/recorder.hpp"
#include "puzzle/session/session.hpp"
#include "render/panels/toasts.hpp"

#include <string>

namespace trembler::ui {

/// Writes the run so far to a file. Shows a message with the file's place, or with the reason why nothing is
/// saved. `level` becomes a part of the file's name.
void saveSolution(Session const& session, std::string const& level, Recorder& recorder,
                  render::Toasts& toasts);

} // namespace trembler::ui
