// Sound: impacts, scrapes and recordings, their loudness for listeners, and sensors that conduct because of
// it.
#pragma once

namespace trembler {

class Registry;

/// Registers properties, rules for files and components of sound. After dynamics and electricity, whose
/// effects it reads; each may be left out, and components that need them are then absent.
void registerSound(Registry& registry);

} // namespace trembler
