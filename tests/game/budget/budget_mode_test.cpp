// The budget mode with a clock that the test sets, and its recordings.
#include "game/budget/budget_mode.hpp"
#include "physics/dynamics/properties/settings.hpp"
#include "runtime/level/read/solutions/read_solutions.hpp"
#include "runtime/level/write/write_level.hpp"
#include "tests/game/budget/knob_kit.hpp"

#include <map>

namespace trembler::budget {
namespace {

/// Microseconds per turn, by the component's title; other components take one.
BudgetMode::Stopwatch clockOf(std::map<std::string, double> each) {
    return [each](World const& world) {
        auto all = world.status();
        for (ComponentStatus& status : all) {
            auto const at = each.find(title(*status.info));
            status.totalMicroseconds =
                static_cast<double>(status.updates) * (at == each.end() ? 1 : at->second);
        }
        return all;
    };
}

class Budget : public Experiment {};

TEST_F(Budget, LookingChangesNothing) {
    open("4-raft.json");
    runTo(130);
    std::uint64_t const alone = world().stateHash();
    open("4-raft.json");
    BudgetMode mode(gameData().registry);
    mode.watch(true);
    for (int i = 0; i < 130; ++i) {
        mode.beforeStep(session());
        step();
    }
    EXPECT_EQ(world().stateHash(), alone);
    EXPECT_TRUE(session().changes().empty());
    EXPECT_FALSE(mode.knobs().empty());
    EXPECT_GT(mode.figures().microseconds, 0);
    EXPECT_GE(mode.figures().worst, mode.figures().microseconds);
}

std::map<std::string, double> const slow{
    {"Real Gravity DPS", 900}, {"Tree Gravity DPS", 300}, {"Dynamics Resolver", 100}};

/// Runs with a budget and returns the hashes at every 60th frame.
std::vector<std::uint64_t> runWith(Session& session, BudgetMode* mode, int frames) {
    std::vector<std::uint64_t> hashes;
    for (int i = 1; i <= frames; ++i) {
        if (mode != nullptr) {
            mode->beforeStep(session);
        }
        session.step();
        if (i % 60 == 0) {
            hashes.push_back(session.world().stateHash());
        }
    }
    return hashes;
}

TEST_F(Budget, IsKeptAndTheRecordingRepeatsBitForBitOnAnyNumberOfThreads) {
    LevelFile level = starDisc(gameData(), 200);
    DynamicsSettings settings; // free flight would get one step automatically
    settings.substeps = 4;
    level.world.set(settings);
    BudgetMode mode(gameData().registry, clockOf(slow));
    mode.setBudget(600);
    constexpr int frames = 420;
    Session first(gameData().registry, gameData().parts, level);
    std::vector<std::uint64_t> const hashes = runWith(first, &mode, frames);
    ASSERT_FALSE(mode.decisions().empty());
    EXPECT_EQ(mode.decisions().front().effect, "gravity");
    EXPECT_GT(mode.decisions().front().microseconds, 0);
    EXPECT_TRUE(mode.kept()) << mode.figures().microseconds;
    EXPECT_LE(mode.decisions().size(), 3U);
    EXPECT_FALSE(first.changes().empty());
    // Through a file, as for a player.
    auto const document = JsonDocument::parse(writeSolution(first.record("kept")).dump(), "kept.json");
    Problems problems;
    auto const solution = readSolution(JsonNode(*document, document->root(), "", problems));
    problems.throwIfAny();
    ASSERT_TRUE(solution);
    for (int const threads : {1, 2, 8}) {
        WorldOptions options;
        options.threads = threads;
        options.rowsWorthThreads = 0;
        Session again(gameData().registry, gameData().parts, level, options);
        again.load(*solution);
        EXPECT_EQ(runWith(again, nullptr, frames), hashes) << threads << " threads";
    }
    // Without the recorded decisions it is another run.
    Session without(gameData().registry, gameData().parts, level);
    EXPECT_NE(runWith(without, nullptr, frames), hashes);
}

TEST_F(Budget, ThatIsLargeIncreasesAccuracyAndOneThatIsTooSmallIsReported) {
    LevelFile const level = starDisc(gameData(), 120);
    WorldOptions options;
    options.detail["gravity"] = "tree";
    Session rich(gameData().registry, gameData().parts, level, options);
    BudgetMode mode(gameData().registry, clockOf(slow));
    mode.setBudget(20000);
    (void)runWith(rich, &mode, 300);
    EXPECT_EQ(mode.knob("gravity")->options[mode.knob("gravity")->current].name, "real");
    EXPECT_LT(mode.error(), 0.02);
    Session poor(gameData().registry, gameData().parts, level, options);
    mode.clear();
    mode.setBudget(20);
    (void)runWith(poor, &mode, 300);
    EXPECT_FALSE(mode.kept());
    Knob const& gravity = *mode.knob("gravity");
    EXPECT_NE(gravity.options[gravity.current].name.find("every 4 frames"), std::string::npos)
        << "the cheapest";
    auto const decisions = mode.decisions().size();
    (void)runWith(poor, &mode, 300);
    EXPECT_EQ(mode.decisions().size(), decisions) << "no further decision";
}

TEST(BudgetWords, StateTheChangeAndItsCost) {
    Decision decision;
    decision.effect = "buoyancy";
    decision.from = "exact";
    decision.to = "64 particles";
    decision.microseconds = 800;
    decision.error = {0.01, 0.02};
    decision.of = "of the lift";
    EXPECT_EQ(inWords(decision), "Buoyancy: exact -> 64 particles: saves 800 µs, error 2 % of the lift");
    decision.microseconds = -1234;
    EXPECT_EQ(inWords(decision), "Buoyancy: exact -> 64 particles: costs 1.23 ms, error 2 % of the lift");
}

} // namespace
} // namespace trembler::budget
