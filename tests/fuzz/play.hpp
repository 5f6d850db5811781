// A world in which a fuzzed script runs, and the conditions that must hold in it whatever the script does.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::lua {

/// Throws std::logic_error with the text if the condition does not hold.
void require(bool holds, std::string_view what);

struct Played {
    bool accepted = false;             ///< the script was read without errors
    std::vector<std::uint64_t> hashes; ///< of every frame
    std::string messages;              ///< of the script, and the reason why it was switched off
};

/// Runs a script for some frames in the world of the reference's examples, beside one that counts its own
/// turns. Requires that every position and velocity is a number and that the other script has all its turns.
[[nodiscard]] Played playScript(std::string const& source, int frames, int threads);

/// Plays a script twice, on one thread and on several, and requires the same hashes and messages.
void playTwice(std::string const& source, int frames);

} // namespace trembler::lua
