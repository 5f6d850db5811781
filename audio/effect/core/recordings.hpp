// Recordings that play: their beginnings, their loudness for listeners in the world, and their ends.
#pragma once

#include "audio/effect/core/sound_work.hpp"

namespace trembler {

/// Advances the recordings in `sounds` by `duration` (s).
void advanceRecordings(SoundColumns const& columns, SoundCalls const& calls, double duration, Sounds& sounds);

} // namespace trembler
