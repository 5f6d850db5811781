// Runs levels twice, once with an interaction in C++ and once with the same one in Lua, and compares the
// worlds after every frame.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "runtime/world/world.hpp"
#include "tests/lua/analysis/counterparts.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace trembler::lua::analysis {

/// One interaction, or several at once, in all recorded plays of all levels.
struct Comparison {
    std::string name;
    int plays = 0;            ///< in which the level activates the interaction and it has a turn
    std::uint64_t frames = 0; ///< compared
    std::uint64_t turns = 0;  ///< of those in C++
    std::optional<std::uint64_t>
        firstDiffers;                ///< the first frame, of any play, after which the worlds differ
    std::string differsIn;           ///< the level and play of that frame
    int differing = 0;               ///< plays in which they do
    double nativeMicroseconds = 0;   ///< per turn
    double scriptMicroseconds = 0;   ///< per turn
    std::vector<std::string> errors; ///< of the script
};

/// Puts the script into the registry in place of the interaction of its name: at its place, with its type (so
/// that a shortcut of 5.7.3 finds it), its conditions of activation, and its turn in the setup. Throws
/// InputError if the script is wrong.
void putInPlace(Registry& registry, Counterpart const& counterpart, std::shared_ptr<ScriptLog> const& log);

/// The hash of every property that the state hash covers. The components' own data is left out, as it differs
/// between the two; it shows in the properties as soon as it has an effect.
[[nodiscard]] std::uint64_t propertyHash(World const& world, Registry const& registry);

/// All levels of the game, and those in tests/lua/analysis/levels for interactions that the game's levels do
/// not activate.
[[nodiscard]] std::vector<std::filesystem::path> comparedLevels(GameData const& data);

/// Compares every interaction that has a script in every play of these levels, in at most `frames` of each.
[[nodiscard]] std::vector<Comparison>
compareAll(GameData const& data, std::vector<std::filesystem::path> const& levels, std::uint64_t frames);
/// The same for several interactions in one world, all with their scripts, which is one play instead of one
/// for each. All of them must have scripts.
[[nodiscard]] Comparison compareTogether(GameData const& data,
                                         std::vector<std::filesystem::path> const& levels,
                                         std::uint64_t frames, std::vector<Counterpart> const& counterparts);

} // namespace trembler::lua::analysis
