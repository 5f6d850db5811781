// The persistent data of a player: settings, keys, and solved levels.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace trembler::ui {

struct Settings {
    float uiScale = 1.F; ///< the player's own factor, 0.5 to 3
    bool shadows = true;
    bool fullscreen = false;
    bool names = false; ///< names of objects in the world
    int volume = 80;    ///< percent; 0: silence
    bool hrtf = false;  ///< binaural sound for headphones
};

/// Saved at once whenever it changes. A file that cannot be read or written is not an error: the profile is
/// then empty, or not saved.
class Profile {
public:
    /// `file` empty: nothing is read or written (tests).
    explicit Profile(std::filesystem::path file = {});

    [[nodiscard]] Settings const& settings() const { return settings_; }
    void setSettings(Settings const& settings);
    [[nodiscard]] bool solved(std::string const& levelId) const { return solved_.count(levelId) != 0; }
    /// Returns true if the level was not marked before.
    bool markSolved(std::string const& levelId);
    /// Whether the file existed, so that these are the player's own settings.
    [[nodiscard]] bool stated() const { return stated_; }

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
    std::set<std::string> solved_;
    bool stated_ = false;
};

} // namespace trembler::ui
