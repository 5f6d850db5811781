// Sound: impacts, scrapes and recordings, their loudness for listeners, and sensors that conduct because of
// it.
#pragma once

namespace trembler {

class Registry;

/// Registers properties, rules for files and components of sound. To be called after dynamics and
/// electricity, which it reads; if one of them is left out, components that need it are absent.
void registerSound(Registry& registry);

} // namespace trembler
