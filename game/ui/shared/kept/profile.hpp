// The persistent data of a player: settings, keys, and solved levels.
#pragma once

#include "puzzle/campaign/progress.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace trembler::ui {

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
};

/// Saved at once whenever it changes. A file that cannot be read or written is not an error: the profile is
/// then empty, or not saved.
class Profile {
public:
    /// `file` empty: nothing is read or written (tests).
    explicit Profile(std::filesystem::path file = {});

    [[nodiscard]] Settings const& settings() const { return settings_; }
    void setSettings(Settings const& settings);
    [[nodiscard]] CampaignProgress const& progress() const { return progress_; }
    [[nodiscard]] bool solved(std::string const& levelId) const { return progress_.of(levelId).solved; }
    /// Returns true if the level was not marked before.
    bool markSolved(std::string const& levelId);
    /// Notes in which kind of way a level was solved; returns true if it differs from all before.
    bool addKind(std::string const& levelId, SolutionKind kind);
    /// Keys other than the defaults: names of keys by command id, as in the file.
    [[nodiscard]] std::map<std::string, std::vector<std::string>> const& keys() const { return keys_; }
    void setKeys(std::map<std::string, std::vector<std::string>> keys);
    /// A sentence for each entry of the keys that could not be read.
    [[nodiscard]] std::vector<std::string> const& troubles() const { return troubles_; }

    /// The default file: $XDG_DATA_HOME/trembler/profile.json, or below ~/.local/share; empty if neither
    /// variable is set.
    [[nodiscard]] static std::filesystem::path usualFile();

private:
    void read();
    void write() const;

    std::filesystem::path file_;
    Settings settings_;
    std::map<std::string, std::vector<std::string>> keys_;
    std::vector<std::string> troubles_;
    CampaignProgress progress_;
};

} // namespace trembler::ui
