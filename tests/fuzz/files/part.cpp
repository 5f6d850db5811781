#include "runtime/level/build/check_composites.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/level/read/read_part.hpp"
#include "tests/fuzz/files/kit.hpp"
#include "tests/fuzz/play.hpp"
#include "tests/fuzz/targets.hpp"

#include <nlohmann/json.hpp>

namespace trembler::files {

void fuzzPart(std::string_view bytes) {
    try {
        auto const document = JsonDocument::parse(std::string(bytes), "fuzz.json");
        PartDefinition part = readPart(gameData().registry, document);
        PartLibrary parts;
        for (PartDefinition const* const known : gameData().parts.all()) {
            if (known->name != part.name) { // it replaces the game's part
                parts.add(*known);
            }
        }
        std::string const name = part.name;
        parts.add(std::move(part));
        checkComposites(parts);
        // The part as an object of a level, beside a fixed floor.
        nlohmann::json const level = {{"version", 2},
                                      {"title", "a part"},
                                      {"world", {{"gravity", {0, -9.81}}, {"bounds", {-20, -20, 40, 40}}}},
                                      {"objects",
                                       {{{"name", "floor"},
                                         {"at", {0, -5}},
                                         {"properties",
                                          {{"material", "stone"},
                                           {"fixed", true},
                                           {"shape", {{{"form", "box"}, {"width", 20}, {"height", 0.5}}}}}}},
                                        {{"name", "it"}, {"part", name}, {"at", {0, 0}}}}}};
        LevelFile const file =
            readLevel(gameData().registry, JsonDocument::parse(level.dump(), "level of fuzz.json"));
        constexpr int frames = 20;
        lua::require(hashesOf(file, parts, nullptr, frames, 1) == hashesOf(file, parts, nullptr, frames, 2),
                     "the hashes depend on the threads");
    } catch (InputError const& error) {
        requireWords(error);
    }
}

} // namespace trembler::files
