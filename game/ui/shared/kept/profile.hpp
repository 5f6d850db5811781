// The persistent data of a player: settings, keys, and solved levels.
#pragma once

#include "game/ui/shared/kept/profile_text.hpp"
#include "game/ui/shared/kept/settings.hpp"
#include "puzzle/campaign/progress.hpp"
#include "runtime/file/output_file.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace trembler::ui {

/// Saved at once whenever it changes, as KeptFile does it. Another instance of the game may change the same
/// file: each adds its own changes to what is there, so that stars only grow, and of each setting the later
/// choice stays. A setting that another instance changes applies here from the next start. What cannot be
/// written is kept here and tried again. Window thread only.
class Profile {
public:
    /// The time for changes, ms since 1970.
    using Clock = std::function<std::int64_t()>;
    /// What could not be written is tried again after this time, s.
    static constexpr double patience = 5;

    /// `file` empty: nothing is read or written (tests). `clock` empty: the computer's.
    explicit Profile(std::filesystem::path file = {}, Clock clock = {});

    [[nodiscard]] Settings const& settings() const { return settings_; }
    void setSettings(Settings const& settings);
    [[nodiscard]] CampaignProgress const& progress() const { return progress_; }
    [[nodiscard]] bool solved(std::string const& levelId) const { return progress_.of(levelId).solved; }
    /// Returns true if the level was not marked before.
    bool markSolved(std::string const& levelId);
    /// Notes in which kind of way a level was solved; returns true if it differs from all before.
    bool addKind(std::string const& levelId, SolutionKind kind);
    /// Keys other than the defaults: names of keys by command id, as in the file.
    [[nodiscard]] StatedKeys const& keys() const { return keys_; }
    void setKeys(StatedKeys keys);
    /// A sentence for each thing that was wrong with the file when it was read: that it was damaged, or which
    /// entries could not be read. In the language in use.
    [[nodiscard]] std::vector<std::string> troubles() const;

    /// Why the last changes are not in the file; nothing if they are.
    [[nodiscard]] std::optional<OutputError> const& unwritten() const { return unwritten_; }
    /// To be called once per picture: tries again to write what could not be written.
    void pass(double seconds);
    /// Tries again at once, before the game ends.
    void finish();

    /// The default file: profile.json in dataFolder(); empty if there is none.
    [[nodiscard]] static std::filesystem::path usualFile();

private:
    void read();
    void change(std::string const& name, nlohmann::ordered_json value);
    void write();

    std::filesystem::path file_;
    Clock clock_;
    Settings settings_;
    StatedKeys keys_;
    CampaignProgress progress_;
    TimedValues values_;           // as far as they were stated or chosen
    std::set<std::string> chosen_; // just now: later than whatever is in the file
    std::vector<std::function<std::string()>> troubles_;
    std::optional<OutputError> unwritten_;
    double sinceTry_ = 0; // s
};

} // namespace trembler::ui
