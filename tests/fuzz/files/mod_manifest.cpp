#include "lua/mods/mod.hpp"
#include "tests/fuzz/files/kit.hpp"
#include "tests/fuzz/play.hpp"
#include "tests/fuzz/targets.hpp"

namespace trembler::files {

namespace fs = std::filesystem;

void fuzzModManifest(std::string_view bytes) {
    fs::path const folder = ownFolder() / "fuzz";
    fs::create_directories(folder / "interactions");
    std::size_t const end = std::min(bytes.find('\0'), bytes.size());
    write(folder / "mod.json", bytes.substr(0, end));
    fs::path const script = folder / "interactions" / "one.lua";
    fs::remove(script);
    if (end < bytes.size()) {
        write(script, bytes.substr(end + 1));
    }
    Problems problems;
    lua::Mod const mod = lua::readMod(folder, problems);
    try {
        problems.throwIfAny();
    } catch (InputError const& error) {
        requireWords(error);
        return;
    }
    lua::require(mod.name == "fuzz" && !mod.version.empty() && !mod.licence.empty(),
                 "a mod is accepted that does not say what it is");
    for (lua::Manifest const& manifest : mod.interactions) {
        lua::require(!manifest.name.empty() && !manifest.calls.empty(),
                     "an interaction is accepted that does not say what it is");
    }
}

} // namespace trembler::files
