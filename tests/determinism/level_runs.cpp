#include "tests/determinism/level_runs.hpp"

#include "physics/dynamics/properties/body.hpp"
#include "runtime/placement.hpp"

namespace trembler::determinism {

namespace {

template <ObjectProperty P>
void addColumn(StateHash& hash, Store const& store) {
    if (auto const* const column = store.findColumn<P>()) {
        column->hash(hash);
    }
}

std::string motionHash(Store const& store) {
    StateHash hash;
    addColumn<Position>(hash, store);
    addColumn<Rotation>(hash, store);
    addColumn<Velocity>(hash, store);
    addColumn<AngularVelocity>(hash, store);
    return hashText(hash.digest());
}

} // namespace

std::map<std::string, RunHashes> hashesOf(LevelFile const& level, int threads, std::uint64_t length) {
    std::map<std::string, RunHashes> all;
    auto const runWith = [&](Solution const* solution) {
        WorldOptions options;
        options.threads = threads;
        options.rowsWorthThreads = 0; // the scenes are small: without this no second thread would ever start
        Session session(gameData().registry, gameData().parts, level, options);
        if (solution != nullptr) {
            session.load(*solution);
        }
        RunOptions run;
        run.frames = length;
        run.hashEvery = every;
        RunHashes hashes;
        run.frame = [&](World const& world) {
            if (world.frame() % every == 0) {
                hashes.motion.push_back(motionHash(world.store()));
            }
        };
        for (HashAt const& at : trembler::run(session, "", run).hashes) {
            hashes.state.push_back(hashText(at.hash));
        }
        return hashes;
    };
    all["hands off"] = runWith(nullptr);
    for (Solution const& solution : level.solutions) {
        all[solution.name] = runWith(&solution);
    }
    return all;
}

} // namespace trembler::determinism
