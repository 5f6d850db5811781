// In any world, a cause that is reported as confirmed is one: without it, what was asked about does not
// happen. And no effect is reported before its cause.
#include "insight/why/answer.hpp"
#include "insight/why/candidates.hpp"
#include "puzzle/goals/level_schema.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/trace/tracer.hpp"
#include "tests/support/game_data.hpp"
#include "tests/worlds/random_level.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

namespace trembler::insight {
namespace {

constexpr std::uint64_t watchedFrames = 60;

/// The level without goals and without what the reader rejects; nothing if too much of it is wrong.
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
                if (diagnostic.file == "random world") { // and not a part's
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
            for (nlohmann::json& object : level["objects"]) { // what is wrong is in a part
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

class WhyInRandomWorlds : public testing::TestWithParam<std::uint64_t> {};

TEST_P(WhyInRandomWorlds, ConfirmedCausesAreCauses) {
    static worlds::RandomLevels const levels(levelSchema(gameData().registry), gameData().parts.names());
    worlds::Manner manner;
    manner.extremes = 0;
    manner.anywhere = 0;
    manner.spread = 1;
    auto const level = readable(levels.make(GetParam(), manner));
    if (!level) {
        GTEST_SKIP() << "the reader rejects the level";
    }
    LevelRuns const runs(gameData(), *level);
    std::uint64_t number = 0;
    traced(runs, {}, watchedFrames, [&](std::span<Event const> events) {
        for (std::size_t i = 0; i < events.size(); ++i) {
            auto const kind = kindOf(events[i]);
            if (kind == StepKind::contact || kind == StepKind::on || kind == StepKind::pull) {
                number = i + 1;
            }
        }
    });
    if (number == 0) {
        GTEST_SKIP() << "nothing touches anything";
    }
    AskOptions options;
    options.frames = watchedFrames;
    Question question;
    question.event = number;
    Answer const answer = why(runs, {}, question, options);
    ASSERT_TRUE(answer.happened);
    ASSERT_FALSE(answer.chain.empty());
    Step const& asked = answer.chain.back().step;
    std::size_t times = 0;
    traced(runs, {}, asked.frame,
           [&](std::span<Event const> events) { times = timesOf(events, asked, asked.frame); });
    std::uint64_t const last = asked.frame + 60; // the horizon of runs that are so short
    for (std::size_t i = 0; i < answer.chain.size(); ++i) {
        ChainStep const& one = answer.chain[i];
        for (std::size_t const cause : one.step.because) {
            EXPECT_LT(cause, i);
            EXPECT_LE(answer.chain[cause].step.frame, one.step.frame);
        }
        if (one.proof != Proof::confirmed || one.step.kind != StepKind::contact ||
            i + 1 == answer.chain.size()) {
            continue;
        }
        auto const first = answer.facts.firstTouch.find(one.step.objects);
        if (first == answer.facts.firstTouch.end() || first->second != one.step.frame) {
            continue; // left out from a later frame on
        }
        LeftOut const without = withoutContact(one.step.objects[0], one.step.objects[1], 1);
        traced(runs, {{}, {without}}, last, [&](std::span<Event const> events) {
            EXPECT_LT(timesOf(events, asked, last), times)
                << one.step.objects[0] << ", " << one.step.objects[1];
        });
    }
}

INSTANTIATE_TEST_SUITE_P(Of, WhyInRandomWorlds, testing::Range<std::uint64_t>(0, 12));

} // namespace
} // namespace trembler::insight
