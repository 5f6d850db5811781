// In any world, a cause that is reported as confirmed is one: without it, the event in question does not
// happen. And no effect is reported before its cause.
#include "insight/why/answer.hpp"
#include "insight/why/runs/candidates.hpp"
#include "puzzle/goals/level_schema.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/placement.hpp"
#include "runtime/trace/tracer.hpp"
#include "tests/support/game_data.hpp"
#include "tests/support/sanitizer.hpp"
#include "tests/worlds/random_level.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <random>

namespace trembler::insight {
namespace {

constexpr std::uint64_t watchedFrames = 60;

/// The level without goals and without the values that the reader rejects; nothing if too many are rejected.
std::optional<LevelFile> readable(nlohmann::json level) {
    for (char const* const key : {"goals", "task", "solutions", "hints", "teaching", "texts"}) {
        level.erase(key);
    }
    for (int attempt = 0; attempt < 60; ++attempt) {
        try {
            LevelFile file =
                readLevel(gameData().registry, JsonDocument::parse(level.dump(), "random world"));
            (void)buildWorld(gameData().registry, file, gameData().parts);
            return file;
        } catch (InputError const& error) {
            std::vector<std::string> paths;
            for (Diagnostic const& diagnostic : error.diagnostics()) {
                if (diagnostic.file == "random world") { // and not a part's file
                    paths.push_back(diagnostic.path);
                }
            }
            std::sort(paths.begin(), paths.end(), [](std::string const& one, std::string const& other) {
                return one.size() != other.size() ? one.size() > other.size() : one > other;
            });
            paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
            bool less = false;
            for (std::string const& path : paths) { // later entries of a list first
                less = worlds::takeAway(level, path) || less;
            }
            for (nlohmann::json& object : level["objects"]) { // the error is in a part
                less = less || object.erase("part") > 0;
            }
            if (!less) {
                return std::nullopt;
            }
        }
    }
    return std::nullopt;
}

std::size_t timesOf(std::span<Event const> events, Step const& asked, std::uint64_t last) {
    return static_cast<std::size_t>(std::count_if(events.begin(), events.end(), [&](Event const& event) {
        return event.frame <= last && event.component == asked.component && event.event == asked.what &&
               event.objects == asked.objects;
    }));
}

/// Calls f(events) with the trace of a run.
template <class F>
void traced(LevelRuns const& runs, Variation const& variation, std::uint64_t frames, F&& f) {
    RunObserver observer;
    observer.end = [&](LevelRun const& run) { f(run.world().tracer()->events()); };
    RunResult const result =
        runs.run(variation, {.frames = frames, .stopWhenSolved = false, .trace = true}, observer);
    ASSERT_FALSE(result.fault) << *result.fault;
}

/// A random run by hand, from a seed: some parts (each once, so that no name depends on another placement), a
/// wire, a push and a cut. Inputs that the level does not accept are left out of it.
Solution drawnSolution(LevelFile& level, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    auto const among = [&](std::size_t count) { return static_cast<std::size_t>(random() % count); };
    auto const between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() % 1000) / 1000;
    };
    Solution solution;
    auto const builds = [&] {
        try {
            (void)LevelRun(gameData().registry, gameData().parts, level, solution.placements, {},
                           solution.wires);
            return true;
        } catch (InputError const&) {
            return false;
        }
    };
    level.placing.reset();
    level.wires = 4;
    level.toolbox.clear();
    for (char const* const part : {"small magnet", "steel bar", "crate", "iron ball", "battery"}) {
        if (gameData().parts.find(part) == nullptr || level.objects.empty()) {
            continue;
        }
        level.toolbox.push_back({part, 1, ""});
        Placement placement;
        placement.part = part;
        auto const* const position = level.objects[among(level.objects.size())].properties.find<Position>();
        placement.at =
            (position == nullptr ? Vec2{} : position->value) + Vec2{between(-0.3, 0.3), between(-0.1, 0.5)};
        solution.placements.push_back(placement);
        if (!builds()) {
            solution.placements.pop_back();
        }
    }
    if (level.objects.size() >= 2) {
        std::size_t const a = among(level.objects.size());
        solution.wires.push_back(
            {level.objects[a].name, level.objects[(a + 1) % level.objects.size()].name, "", "wire"});
        if (!builds()) {
            solution.wires.pop_back();
        }
    }
    using Kind = PlayerInput::Kind;
    if (!level.objects.empty()) {
        LevelObject const& pushed = level.objects[among(level.objects.size())];
        auto const* const position = pushed.properties.find<Position>();
        Vec2 const at = position == nullptr ? Vec2{} : position->value;
        solution.inputs.push_back({5, Kind::grab, pushed.name, "", at, "", 0});
        solution.inputs.push_back({6, Kind::move, "", "", at + Vec2{between(-1, 1), between(0, 1)}, "", 0});
        solution.inputs.push_back({25, Kind::release, "", "", {}, "", 0});
    }
    if (!level.connections.empty()) {
        LevelConnection const& cut = level.connections[among(level.connections.size())];
        solution.inputs.push_back({30, Kind::cut, cut.a, cut.b, {}, "", 0});
    }
    return solution;
}

/// The changes for a run without a step, which is a contact (from the pair's first touch on) or an action;
/// nothing for other steps.
std::vector<LeftOut> withoutStep(Step const& step, SceneFacts const& facts, Solution const& solution) {
    switch (step.kind) {
    case StepKind::contact: {
        auto const first = facts.firstTouch.find(step.objects);
        if (first == facts.firstTouch.end() || first->second != step.frame) {
            return {}; // left out from a later frame on
        }
        return {withoutContact(step.objects[0], step.objects[1], 1)};
    }
    case StepKind::placed:
        return {withoutPlacement(facts.placementOf.at(step.objects.front()))};
    case StepKind::wired:
        return {withoutWire(0)};
    case StepKind::grabbed:
        return {withoutInput(0), withoutInput(1), withoutInput(2)};
    case StepKind::cut:
        return {withoutInput(solution.inputs.size() - 1)};
    case StepKind::pull:
    case StepKind::push: // from the start; an earlier pull of its magnet need not be in the chain
        return facts.magnets.contains(step.objects.back()) && step.frame == 1
                   ? std::vector{withoutDevice(step.objects.back(), 1)}
                   : std::vector<LeftOut>{};
    default:
        return {};
    }
}

using CheckedKinds = std::map<StepKind, int>;

/// Asks about the last event of a kind, and runs without each confirmed cause. Counts the steps of each kind
/// that were left out.
void expectTrueCauses(LevelRuns const& runs, Solution const& solution, CheckedKinds& checked) {
    std::uint64_t number = 0;
    traced(runs, {solution}, watchedFrames, [&](std::span<Event const> events) {
        for (std::size_t i = 0; i < events.size(); ++i) {
            auto const kind = kindOf(events[i]);
            if (kind == StepKind::contact || kind == StepKind::on || kind == StepKind::off ||
                (kind && isPull(*kind))) {
                number = i + 1;
            }
        }
    });
    if (number == 0) {
        return; // there are no such events
    }
    AskOptions options;
    options.frames = watchedFrames;
    Question question;
    question.event = number;
    Answer const answer = why(runs, solution, question, options);
    ASSERT_TRUE(answer.happened);
    ASSERT_FALSE(answer.chain.empty());
    Step const& asked = answer.chain.back().step;
    std::size_t times = 0;
    traced(runs, {solution}, asked.frame,
           [&](std::span<Event const> events) { times = timesOf(events, asked, asked.frame); });
    std::uint64_t const last = asked.frame + 60; // the horizon of runs that are so short
    for (std::size_t i = 0; i < answer.chain.size(); ++i) {
        ChainStep const& one = answer.chain[i];
        for (std::size_t const cause : one.step.because) {
            EXPECT_LT(cause, i);
            Step const& before = answer.chain[cause].step;
            EXPECT_LE(before.frame + (isPull(before.kind) ? 1 : 0), one.step.frame);
        }
        if (!one.step.traced) {
            EXPECT_TRUE(one.proof == Proof::confirmed || one.proof == Proof::together)
                << "neither the trace nor a run connects it: " << one.step.what;
        }
        // A step that is no candidate is confirmed by its causes, see docs/why.md.
        bool const candidate = !one.step.bridge && !isGranted(one.step, answer.facts);
        if (one.proof != Proof::confirmed || i + 1 == answer.chain.size() || !candidate) {
            continue;
        }
        std::vector<LeftOut> const without = withoutStep(one.step, answer.facts, solution);
        if (without.empty()) {
            continue;
        }
        ++checked[one.step.kind];
        traced(runs, {solution, without}, last, [&](std::span<Event const> events) {
            EXPECT_LT(timesOf(events, asked, last), times) << one.step.what << ": " << one.step.objects[0];
        });
    }
}

std::optional<LevelFile> randomLevel(std::uint64_t seed, int objects) {
    static worlds::RandomLevels const levels(levelSchema(gameData().registry), gameData().parts.names());
    worlds::Manner manner;
    manner.extremes = 0;
    manner.anywhere = 0;
    manner.spread = 1;
    manner.objects = objects;
    manner.joints = objects / 2;
    return readable(levels.make(seed, manner));
}

class WhyInRandomWorlds : public testing::TestWithParam<std::uint64_t> {};

TEST_P(WhyInRandomWorlds, ConfirmedCausesAreCauses) {
    auto const level = randomLevel(GetParam(), 8);
    if (!level) {
        GTEST_SKIP() << "the reader rejects the level";
    }
    CheckedKinds checked;
    expectTrueCauses(LevelRuns(gameData(), *level), {}, checked);
}

INSTANTIATE_TEST_SUITE_P(Of, WhyInRandomWorlds, testing::Range<std::uint64_t>(0, 12));

// The same for actions of a player: placed parts, among them magnets, a wire, a push and a cut.
TEST(WhyInRandomRuns, ConfirmedDeedsAreCauses) {
    CheckedKinds checked;
    std::uint64_t const end = test::underSanitizer ? 103 : 112;
    for (std::uint64_t seed = 100; seed < end; ++seed) {
        auto level = randomLevel(seed, 3);
        if (!level) {
            continue;
        }
        SCOPED_TRACE(seed);
        Solution const solution = drawnSolution(*level, seed);
        expectTrueCauses(LevelRuns(gameData(), *level), solution, checked);
    }
    if (test::underSanitizer) {
        return; // so few may have none
    }
    EXPECT_GT(checked[StepKind::placed], 2);
    EXPECT_GT(checked[StepKind::placed] + checked[StepKind::wired] + checked[StepKind::grabbed] +
                  checked[StepKind::cut],
              4);
}

} // namespace
} // namespace trembler::insight
