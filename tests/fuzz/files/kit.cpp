#include "tests/fuzz/files/kit.hpp"

#include "physics/dynamics/properties/body.hpp"
#include "puzzle/session/session.hpp"
#include "runtime/placement.hpp"
#include "tests/fuzz/play.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <unistd.h>

namespace trembler::files {

namespace fs = std::filesystem;

void requireWords(InputError const& error) {
    lua::require(!error.diagnostics().empty(), "a file is refused without a problem");
    for (Diagnostic const& diagnostic : error.diagnostics()) {
        lua::require(!diagnostic.message.empty(), "a problem says nothing");
        lua::require(!diagnostic.print().empty(), "a problem prints nothing");
    }
}

fs::path ownFolder() {
    fs::path folder = fs::temp_directory_path() / fmt::format("trembler-fuzz-{}", ::getpid());
    fs::create_directories(folder);
    return folder;
}

void write(fs::path const& file, std::string_view bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

std::vector<std::uint64_t> hashesOf(LevelFile const& level, PartLibrary const& parts,
                                    Solution const* solution, int frames, int threads) {
    Session session(gameData().registry, parts, level,
                    WorldOptions{.threads = threads, .detail = level.detail, .periods = {}});
    if (solution != nullptr) {
        session.load(*solution);
    }
    std::vector<std::uint64_t> hashes;
    for (int frame = 0; frame < frames; ++frame) {
        session.step();
        hashes.push_back(session.world().stateHash());
    }
    Store const& store = session.world().store();
    auto const finite = [](Vec2 v) { return std::isfinite(v.x) && std::isfinite(v.y); };
    if (auto const* const positions = store.findColumn<Position>()) {
        for (ObjectId const id : positions->owners()) {
            lua::require(finite(positions->find(id)->value), "a position is no number");
        }
    }
    if (auto const* const velocities = store.findColumn<Velocity>()) {
        for (ObjectId const id : velocities->owners()) {
            lua::require(finite(velocities->find(id)->value), "a velocity is no number");
        }
    }
    return hashes;
}

} // namespace trembler::files
