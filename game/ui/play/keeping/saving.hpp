// Keeping what was placed and done, as a solution file.
#pragma once

#include "game/ui/shared/recorder.hpp"
#include "puzzle/session/session.hpp"
#include "render/panels/toasts.hpp"

#include <string>

namespace trembler::ui {

/// Writes the run so far and says where, or says why there is nothing to be kept. `level` goes into the
/// file's name.
void saveSolution(Session const& session, std::string const& level, Recorder& recorder,
                  render::Toasts& toasts);

} // namespace trembler::ui
