// Repeats the run of a session: for stages, and for runs beside the real one.
#pragma once

#include "puzzle/session/session.hpp"

#include <memory>

namespace trembler::insight {

/// A run of the session's level as it is placed, before its first frame, with the options that the session's
/// run began with. `registry` is the session's; it, the session's level and its parts must outlive the run.
/// Throws InputError if the world cannot be built any more, as when a script was changed.
[[nodiscard]] std::unique_ptr<LevelRun> buildAgain(Registry const& registry, Session const& session);

/// The inputs and changes of the session's run up to that frame: fed to another run of it, they repeat it to
/// the bit.
[[nodiscard]] Playback playbackTo(Session const& session, std::uint64_t frame);

} // namespace trembler::insight
