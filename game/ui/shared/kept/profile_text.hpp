// The text of a profile's file, and how the changes of two programs become one text.
//
//     {"volume": 30, ..., "keys": {"run": ["F5"]}, "progress": {...},
//      "changed_at": {"volume": 1764230400000, "keys.run": 1764230400500, ...}}
//
// Each setting, and the keys of each command, have the time of their last change by the player. Entries that
// the program does not know stay as they are: a newer version may have written them.
#pragma once

#include "game/ui/shared/kept/settings.hpp"
#include "puzzle/campaign/progress.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::ui {

/// A setting's or command's value with the time at which the player chose it, ms since 1970; 0: unknown.
struct TimedValue {
    nlohmann::ordered_json value; ///< null: back to the default
    std::int64_t at = 0;
};
/// By name: "volume", "keys.run".
using TimedValues = std::map<std::string, TimedValue>;

/// Whether a text is a whole profile: a JSON object in which progress, if there is any, is an object.
[[nodiscard]] bool isWholeProfile(std::string_view text);

/// The entries of a profile as this program understands them. Ranges are kept by limiting numbers.
struct ProfileEntries {
    TimedValues values; ///< those that the file states; the names of others are not in it
    CampaignProgress progress;
    /// For each entry that is not understood a sentence, in the language that is in use when it is made: the
    /// profile is read before its language is known.
    std::vector<std::function<std::string()>> troubles;
};
/// Reads a text for which isWholeProfile() is true. Damaged entries do not affect the others.
[[nodiscard]] ProfileEntries readProfile(std::string_view text);

/// All settings by their names in the file.
[[nodiscard]] std::map<std::string, nlohmann::ordered_json> valuesOf(Settings const& settings);
/// The settings and keys that the values state; the others have their defaults.
[[nodiscard]] Settings settingsOf(TimedValues const& values);
[[nodiscard]] StatedKeys keysOf(TimedValues const& values);
/// The name of a command's keys: "keys.run"
[[nodiscard]] std::string nameOfKeys(std::string_view command);

/// Of all levels, also as versions before the kinds of solutions stated it.
[[nodiscard]] CampaignProgress progressOf(nlohmann::ordered_json const& profile);
/// When the value of that name was changed, in a text; -1 if it has none.
[[nodiscard]] std::int64_t changedAt(nlohmann::ordered_json const& profile, std::string const& name);

/// The present content of the file with values and progress of one program: of each value the one that was
/// chosen later stays, of each level all stars. `present` is an object. The order in which programs add
/// theirs makes no difference to values.
[[nodiscard]] nlohmann::ordered_json withAdded(nlohmann::ordered_json present, TimedValues const& values,
                                               CampaignProgress const& progress);

} // namespace trembler::ui
