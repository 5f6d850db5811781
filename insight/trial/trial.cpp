#include "insight/trial/trial.hpp"

#include "insight/miss/miss_meter.hpp"
#include "puzzle/session/fit.hpp"
#include "puzzle/session/playback.hpp"
#include "puzzle/session/zone.hpp"
#include "runtime/level/build/placing.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace trembler::insight {
namespace {

constexpr std::uint64_t restEvery = 16;       // frames between tests whether the world is at rest
constexpr std::uint64_t usualFrames = 3600;   // as `trembler verify` runs a solution
constexpr std::uint64_t framesForSensors = 4; // a contact takes three frames to have its effect

std::optional<std::string> whyNotPlacedIn(LevelUnderTest const& level, LevelRun const& run,
                                          Solution const& solution) {
    for (std::size_t i = 0; i < solution.placements.size(); ++i) {
        std::vector<ObjectId> const own = run.pieces(Origin::Kind::placement, i);
        if (auto why = whyItDoesNotFit(run.world(), level.data().parts, solution.placements[i], own)) {
            return why;
        }
    }
    return std::nullopt;
}

/// The rule of the level that forbids the placements; checked before there is a world.
std::optional<std::string> whyNotAllowed(LevelUnderTest const& level, Solution const& solution) {
    PlacementCount count(level.level(), level.data().parts);
    for (Placement const& placement : solution.placements) {
        if (auto why = count.add(placement)) {
            return why;
        }
        if (auto why = whyItSticksOut(level.level(), level.data().parts, placement)) {
            return why;
        }
    }
    return std::nullopt;
}

/// Notices when a world is at rest: its hash is the same before and after a frame.
class RestWatch {
public:
    explicit RestWatch(Solution const& solution) {
        for (RecordedInput const& input : solution.inputs) {
            lastInput_ = std::max(lastInput_, input.frame);
        }
        for (RecordedChange const& change : solution.changes) {
            lastInput_ = std::max(lastInput_, change.frame);
        }
    }
    /// To be called after every frame. The frame since which it is at rest, if it is.
    [[nodiscard]] std::optional<std::uint64_t> look(World const& world) {
        std::uint64_t const frame = world.frame();
        if (rest_ || frame <= lastInput_ + framesForSensors) {
            return rest_;
        }
        if (frame % restEvery == 0) {
            hash_ = world.stateHash();
            hashed_ = frame;
        } else if (hashed_ + 1 == frame && hash_ == world.stateHash()) {
            rest_ = frame;
        }
        return rest_;
    }

private:
    std::uint64_t lastInput_ = 0;
    std::uint64_t hash_ = 0;
    std::uint64_t hashed_ = 0; // the frame after which hash_ was taken; 0: none
    std::optional<std::uint64_t> rest_;
};

/// Adds what a miss lacks, and what stood in the way besides.
void addLacking(Miss const& miss, std::vector<Lacking>& to) {
    constexpr std::size_t most = 8;
    if (miss.lack == Lack::distance && to.size() < most) {
        to.push_back({miss.from, miss.to, false});
    }
    for (CircuitGap const& gap : miss.gaps) {
        if (gap.reason == GapReason::apart && to.size() < most) {
            to.push_back({gap.from, gap.to, true});
        }
    }
    for (Miss const& other : miss.besides) {
        addLacking(other, to);
    }
}

} // namespace

TrialResult tryOut(LevelUnderTest const& level, Solution const& solution, TrialOptions const& options) {
    TrialResult result;
    if (options.mustFit && whyNotAllowed(level, solution)) {
        result.fits = false;
        return result;
    }
    Registry const& registry = options.registry == nullptr ? level.data().registry : *options.registry;
    LevelRun run(registry, level.data().parts, level.level(), solution.placements, {}, solution.wires);
    if (options.mustFit && whyNotPlacedIn(level, run, solution)) {
        result.fits = false;
        return result;
    }
    Playback const playback(solution.inputs, solution.changes);
    RestWatch rest(solution);
    std::optional<MissMeter> meter;
    if (options.measureMiss) {
        meter.emplace(level.level(), run.world());
    }
    run.begin();
    std::uint64_t most = options.frames;
    while (run.world().frame() < most && !run.judge().solved()) {
        playback.feed(run);
        run.step();
        if (meter) {
            meter->look(run.world());
        }
        if (auto const since = rest.look(run.world())) {
            most = std::min(most, *since + level.holdingFrames() + framesForSensors);
        }
    }
    result.solved = run.judge().solved();
    result.frame = result.solved ? *run.judge().solvedFrame() : run.world().frame();
    if (result.solved) {
        result.miss = 0;
    } else if (meter) {
        result.miss = meter->result().measure;
        for (GoalMiss const& goal : meter->result().goals) {
            addLacking(goal.nearest, result.lacking);
        }
    }
    return result;
}

std::optional<std::string> whyNotPlaced(LevelUnderTest const& level, Solution const& solution) {
    if (auto why = whyNotAllowed(level, solution)) {
        return why;
    }
    LevelRun const run(level.data().registry, level.data().parts, level.level(), solution.placements, {},
                       solution.wires);
    return whyNotPlacedIn(level, run, solution);
}

std::string toText(TrialResult const& result) {
    nlohmann::json lacking = nlohmann::json::array();
    for (Lacking const& one : result.lacking) {
        lacking.push_back({one.from.x, one.from.y, one.to.x, one.to.y, one.isGap});
    }
    return nlohmann::json{result.fits, result.solved, result.frame, result.miss, lacking}.dump();
}

TrialResult trialFrom(std::string const& text) {
    nlohmann::json const all = nlohmann::json::parse(text);
    TrialResult result;
    result.fits = all.at(0).get<bool>();
    result.solved = all.at(1).get<bool>();
    result.frame = all.at(2).get<std::uint64_t>();
    result.miss = all.at(3).get<double>();
    for (nlohmann::json const& one : all.at(4)) {
        result.lacking.push_back({{one.at(0).get<double>(), one.at(1).get<double>()},
                                  {one.at(2).get<double>(), one.at(3).get<double>()},
                                  one.at(4).get<bool>()});
    }
    return result;
}

std::uint64_t framesOf(Solution const& solution) {
    return solution.frames ? static_cast<std::uint64_t>(*solution.frames) : usualFrames;
}

std::uint64_t patience(std::uint64_t solvedFrame, std::uint64_t most) {
    constexpr std::uint64_t grace = 300;
    return std::min(most, 2 * solvedFrame + grace);
}

} // namespace trembler::insight
