// Attacks of scripts that try to get an address, or a text above its limit, each by another route.
#pragma once

#include <span>
#include <string_view>

namespace trembler::lua {

struct TextAttack {
    std::string_view name;
    /// A chunk. What it returns, in tables too, and logs are the texts that it has got. It also has try(),
    /// xtry() and resume(): pcall(), xpcall() and coroutine.resume() with the results in a table. NAME stands
    /// for a name of 5000 letters.
    std::string_view chunk;
};

[[nodiscard]] std::span<TextAttack const> textAttacks();

} // namespace trembler::lua
