// Saving the player's placements and inputs as a solution file.
#pragma once

#include "game/ui/shared/kept/pending_writes.hpp"
#include "game/ui/shared/kept/saved_solutions.hpp"
#include "puzzle/session/session.hpp"
#include "render/panels/toasts.hpp"

#include <string>

namespace trembler::ui {

/// Writes the run so far to a file. Shows a message with the name by which the solution is found, or with the
/// reason why nothing is saved; if it is the disk's, it is tried again. `levelId`: among whose solutions it
/// is listed. `saved` must outlive `pending`.
void saveSolution(Session const& session, std::string const& levelId, SavedSolutions const& saved,
                  render::Toasts& toasts, PendingWrites& pending);

} // namespace trembler::ui
