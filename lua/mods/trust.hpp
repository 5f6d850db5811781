// Which mods are trusted, and which limits scripts may request: the player's decisions, in a file of the
// user's configuration.
#pragma once

#include "lua/mods/mod.hpp"

#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace trembler::lua {

/// The file mods.json in the user's configuration:
///
///     {"trusted": ["my-mod"], "most": {"instructions": 400000, "memory": 33554432}}
///
/// `most` are the greatest limits that scripts may state, by their keys in scripts; a missing limit keeps the
/// program's own value.
struct ModSettings {
    std::set<std::string, std::less<>> trusted; ///< names of mods
    ScriptLimits most = ScriptLimits::greatest();
};

/// $XDG_CONFIG_HOME/trembler/mods.json, or that in ~/.config; empty if there is no home.
[[nodiscard]] std::filesystem::path modSettingsFile();
/// A missing file states nothing. Adds the errors of a file to `problems`; its correct entries still count.
[[nodiscard]] ModSettings readModSettings(std::filesystem::path const& file, Problems& problems);

/// Trusts mods of these names too, for as long as the program runs. Thread-safe.
void trustForThisRun(std::vector<std::string> const& names);
/// Makes scripts trusted whose mods came with the program, are in the settings or were named to
/// trustForThisRun(). The settings do not apply to a mod beside a level: another author may have given it
/// the name of a trusted mod. Nothing that scripts compute depends on trust: see Trust.
void applyTrust(std::span<Mod> mods, ModSettings const& settings);

} // namespace trembler::lua
