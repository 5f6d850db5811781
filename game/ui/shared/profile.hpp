// What the program remembers of a player from one day to the next: settings, and which levels are solved.
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
    bool hrtf = false;  ///< directions as ears tell them, for headphones
};

/// Written at once whenever it changes. A file that cannot be read or written is no reason to stop playing:
/// the profile is then simply empty, or not kept.
class Profile {
public:
    /// `file` empty: nothing is read or written (tests).
    explicit Profile(std::filesystem::path file = {});

    [[nodiscard]] Settings const& settings() const { return settings_; }
    void setSettings(Settings const& settings);
    [[nodiscard]] bool solved(std::string const& levelId) const { return solved_.count(levelId) != 0; }
    /// True if it was not marked before.
    bool markSolved(std::string const& levelId);
    /// There was a file: these are the player's own settings.
    [[nodiscard]] bool stated() const { return stated_; }

    /// Keys other than the usual ones, by ids of commands and names of keys, as the file has them.
    [[nodiscard]] std::map<std::string, std::vector<std::string>> const& keys() const { return keys_; }
    void setKeys(std::map<std::string, std::vector<std::string>> keys);
    /// What could not be read of the keys, a sentence for each.
    [[nodiscard]] std::vector<std::string> const& troubles() const { return troubles_; }

    /// $XDG_DATA_HOME/trembler/profile.json, or below ~/.local/share; empty if there is no home.
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
