// Changes of a running world are recorded and repeated.
#include "physics/dynamics/properties/settings.hpp"
#include "puzzle/solutions/solution_file.hpp"
#include "runtime/level/model/world_change.hpp"
#include "runtime/level/read/solutions/read_solutions.hpp"
#include "runtime/level/write/write_level.hpp"
#include "tests/support/experiment.hpp"

namespace trembler {
namespace {

class ChangesInALevel : public Experiment {
protected:
    static RecordedChange make(RecordedChange::Kind kind, std::string subject, std::string field,
                               double value, std::string level = {}) {
        RecordedChange change;
        change.kind = kind;
        change.subject = std::move(subject);
        change.field = std::move(field);
        change.level = std::move(level);
        change.value = value;
        return change;
    }
    using Kind = RecordedChange::Kind;
};

TEST_F(ChangesInALevel, OfUnknownEffectsComponentsAndSettingsAreRefused) {
    std::vector<RecordedChange> const changes{make(Kind::detail, "gravity", "", 0, "moon"),
                                              make(Kind::detail, "telepathy", "", 0, "strong"),
                                              make(Kind::period, "Nobody", "", 2),
                                              make(Kind::setting, "sovler", "substeps", 2),
                                              make(Kind::setting, "solver", "substep", 2),
                                              make(Kind::setting, "solver", "substeps", 1000),
                                              make(Kind::setting, "solver", "substeps", 2.5),
                                              make(Kind::setting, "shape", "value", 2),
                                              make(Kind::setting, "solver", "substeps", std::nan("")),
                                              make(Kind::setting, "solver", "substeps", 2)};
    std::vector<std::string> const says{"linear", "gravity", "Nobody", "solver", "substeps",
                                        "1000",   "whole",   "solver", "nan"};
    for (std::size_t i = 0; i < says.size(); ++i) {
        auto const fault = faultIn(gameData().registry, changes[i]);
        ASSERT_TRUE(fault) << inWords(changes[i]);
        EXPECT_NE(inWords(*fault).find(says[i]), std::string::npos) << inWords(*fault);
    }
    EXPECT_FALSE(faultIn(gameData().registry, changes.back()));
    open("4-raft.json");
    Solution solution;
    solution.name = "bad";
    solution.changes = {changes.front()};
    EXPECT_THROW(session().load(solution), InputError);
}

TEST_F(ChangesInALevel, HoldFromTheirFrameToTheEndOfTheRun) {
    open("4-raft.json");
    RecordedChange const change = make(Kind::setting, "solver", "substeps", 2);
    session().change(change);
    EXPECT_TRUE(session().changes().empty()) << "no run has begun";
    for (int i = 0; i < 10; ++i) {
        step();
    }
    EXPECT_FALSE(holds(gameData().registry, world(), change));
    session().change(change);
    EXPECT_TRUE(holds(gameData().registry, world(), change));
    ASSERT_EQ(session().changes().size(), 1U);
    EXPECT_EQ(session().changes()[0].frame, 11U);
    EXPECT_EQ(world().store().findColumn<DynamicsSettings>()->values().front().substeps, 2);
    session().stop();
    EXPECT_FALSE(holds(gameData().registry, world(), change));
}

// Changes by the player, before and during the run, are part of the recording.
TEST_F(ChangesInALevel, ARecordedRunRepeatsWithThePlayersChanges) {
    std::vector<std::uint64_t> hashes;
    Solution solution;
    {
        open("4-raft.json");
        session().setDetail("buoyancy", "particles");
        session().setPeriod("Liquid Drag", 3); // without "DPS"
        for (int i = 0; i < 40; ++i) {
            step();
        }
        session().setDetail("buoyancy", "");
        session().setPeriod("Buoyancy Resolver", 5);
        for (int i = 0; i < 20; ++i) {
            step();
        }
        session().change(make(Kind::setting, "solver", "substeps", 1));
        for (int i = 0; i < 60; ++i) {
            step();
        }
        hashes.push_back(world().stateHash());
        auto const document =
            JsonDocument::parse(writeSolution(session().record("kept")).dump(), "solution.json");
        Problems problems;
        solution = *readSolution(JsonNode(*document, document->root(), "", problems));
        problems.throwIfAny();
        session().startAgain();
        EXPECT_EQ(world().frame(), 0U);
        EXPECT_EQ(world().options().detail.at("buoyancy"), "particles") << "as when it began";
    }
    open("4-raft.json");
    session().load(solution);
    runTo(120);
    EXPECT_EQ(world().stateHash(), hashes[0]);
    Solution without = solution;
    without.changes.clear();
    session().load(without);
    runTo(120);
    EXPECT_NE(world().stateHash(), hashes[0]) << "so the changes have an effect";
}

} // namespace
} // namespace trembler
