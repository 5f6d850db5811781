// Recordings that play: when they begin, how loud they are for listeners in the world, when they end.
#pragma once

#include "audio/effect/core/sound_work.hpp"

namespace trembler {

/// Moves the recordings in `sounds` on by `duration` (s).
void advanceRecordings(SoundColumns const& columns, SoundCalls const& calls, double duration, Sounds& sounds);

} // namespace trembler
