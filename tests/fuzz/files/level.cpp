#include "runtime/level/read/read_level.hpp"
#include "tests/fuzz/files/kit.hpp"
#include "tests/fuzz/play.hpp"
#include "tests/fuzz/targets.hpp"

namespace trembler::files {

void fuzzLevel(std::string_view bytes) {
    try {
        LevelFile const level =
            readLevel(gameData().registry, JsonDocument::parse(std::string(bytes), "fuzz.json"));
        constexpr int frames = 20;
        auto const hashes = hashesOf(level, gameData().parts, nullptr, frames, 1);
        lua::require(hashes == hashesOf(level, gameData().parts, nullptr, frames, 2),
                     "the hashes depend on the threads");
        for (Solution const& solution : level.solutions) {
            static_cast<void>(hashesOf(level, gameData().parts, &solution, frames, 1));
        }
    } catch (InputError const& error) {
        requireWords(error);
    }
}

} // namespace trembler::files
