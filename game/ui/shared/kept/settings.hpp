// The player's settings and keys.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace trembler::ui {

/// Names of keys by command id, as the profile states them; commands without an entry have their defaults.
using StatedKeys = std::map<std::string, std::vector<std::string>>;

struct Settings {
    float uiScale = 1.F; ///< the player's own factor, 0.5 to 3
    bool shadows = true;
    bool shadowsChosen = false; ///< by the player: otherwise the graphics driver decides
    bool fullscreen = false;
    bool names = false;         ///< names of objects in the world
    int volume = 80;            ///< percent; 0: silence
    int touches = 50;           ///< percent of that, for the interface's own sounds
    bool hrtf = false;          ///< binaural sound for headphones
    bool reducedMotion = false; ///< nothing moves for decoration alone
    bool padIsSecond = false;   ///< the last gamepad is the second player's, even if it is the only one
    bool clearColours = false;  ///< colours that colour-blind eyes distinguish best
    std::string language{};     ///< "en", "de"; empty: that of the desktop

    bool operator==(Settings const&) const = default;
};

} // namespace trembler::ui
