#include "puzzle/run/runner.hpp"

#include "puzzle/run/warnings.hpp"

#include <algorithm>
#include <chrono>
#include <ostream>

namespace trembler {

RunReport run(Session& session, std::string levelName, RunOptions const& options) {
    RunReport report;
    report.level = std::move(levelName);
    session.stop();
    report.warnings = refusedPlaces(session);
    if (options.enter) {
        options.enter(session);
    }
    FrameTimer timer = options.timer;
    std::size_t traced = 0;
    auto const before = std::chrono::steady_clock::now();
    for (std::uint64_t frame = 1; frame <= options.frames; ++frame) {
        if (options.before) {
            options.before(session);
        }
        if (options.slow) {
            timer.begin();
        }
        session.step();
        World const& world = session.world();
        if (options.slow) {
            if (auto const slow = timer.end(world)) {
                options.slow(*slow);
            }
        }
        if (options.frame) {
            options.frame(world);
        }
        report.parts = std::max(report.parts, world.moment().parts);
        if (session.solved() && !report.solvedFrame) {
            report.solvedFrame = frame;
        }
        if (options.hashEvery != 0 && frame % options.hashEvery == 0) {
            report.hashes.push_back({frame, world.stateHash()});
        }
        if (options.trace != nullptr && world.tracer() != nullptr) {
            world.tracer()->write(*options.trace, traced);
            traced = world.tracer()->events().size();
        }
        if (options.progress) {
            options.progress(frame);
        }
        if (options.stopWhenSolved && session.solved()) {
            break;
        }
    }
    report.wallSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
    World const& world = session.world();
    report.frames = world.frame();
    report.threads = world.options().threads;
    report.solved = report.solvedFrame.has_value();
    report.stateHash = world.stateHash();
    report.effects = world.status();
    for (std::string& warning : warningsOf(world)) {
        report.warnings.push_back(std::move(warning));
    }
    for (GoalStatus const& goal : session.judge().status()) {
        report.goals.push_back({goal.id, goal.text, goal.met, goal.frame});
    }
    return report;
}

} // namespace trembler
