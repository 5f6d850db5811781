// Saving the player's placements and inputs as a solution file.
#pragma once

#include "game/ui/shared/kept/saved_solutions.hpp"
#include "puzzle/session/session.hpp"
#include "render/panels/toasts.hpp"

#include <string>

namespace trembler::ui {

/// Writes the run so far to a file. Shows a message with the file's place, or with the reason why nothing is
/// saved. `levelId`: among whose solutions it is listed.
void saveSolution(Session const& session, std::string const& levelId, SavedSolutions const& saved,
                  render::Toasts& toasts);

} // namespace trembler::ui
