#include "tests/determinism/level_runs.hpp"

namespace trembler::determinism {

Workshop const& workshop() {
    static Workshop const shared;
    return shared;
}

std::map<std::string, std::vector<std::string>> hashesOf(LevelFile const& level, int threads) {
    std::map<std::string, std::vector<std::string>> all;
    auto const runWith = [&](Solution const* solution) {
        WorldOptions options;
        options.threads = threads;
        options.rowsWorthThreads = 0; // the scenes are small: without this no second thread would ever start
        Session session(workshop().registry, workshop().parts, level, options);
        if (solution != nullptr) {
            session.load(*solution);
        }
        RunOptions run;
        run.frames = frames;
        run.hashEvery = every;
        std::vector<std::string> hashes;
        for (HashAt const& at : trembler::run(session, "", run).hashes) {
            hashes.push_back(hashText(at.hash));
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
