// Changes of a running world are recorded, written, read and repeated.
#include "physics/dynamics/properties/settings.hpp"
#include "puzzle/solutions/solution_file.hpp"
#include "runtime/level/model/world_change.hpp"
#include "runtime/level/read/read_changes.hpp"
#include "runtime/level/read/read_solutions.hpp"
#include "runtime/level/write/write_level.hpp"
#include "tests/support/experiment.hpp"

namespace trembler {
namespace {

std::optional<Solution> read(std::string const& text, std::vector<std::string>* wrong = nullptr) {
    auto const document = JsonDocument::parse(text, "solution.json");
    Problems problems;
    auto solution = readSolution(JsonNode(*document, document->root(), "", problems));
    try {
        problems.throwIfAny();
    } catch (InputError const& error) {
        for (Diagnostic const& diagnostic : error.diagnostics()) {
            if (wrong != nullptr) {
                wrong->push_back(diagnostic.print());
            }
        }
        return std::nullopt;
    }
    return solution;
}

TEST(Changes, AreWrittenAsTheyAreRead) {
    auto const first = read(R"({"name": "n", "changes": [
        {"frame": 90, "detail": {"gravity": "tree", "electricity": ""}},
        {"frame": 61, "period": {"Buoyancy Resolver": 4}},
        {"frame": 61, "setting": {"gravity_law": {"opening_angle": 0.5}, "solver": {"substeps": 2}}}]})");
    ASSERT_TRUE(first);
    ASSERT_EQ(first->changes.size(), 5U);
    EXPECT_EQ(first->changes[0].frame, 61U) << "in order of time";
    EXPECT_EQ(inWords(first->changes[0]), "Buoyancy Resolver: every 4 frames");
    EXPECT_EQ(inWords(first->changes[1]), "gravity_law: opening_angle 0.5");
    EXPECT_EQ(inWords(first->changes[4]), "gravity: tree");
    auto const again = read(writeSolution(*first).dump());
    ASSERT_TRUE(again);
    ASSERT_EQ(again->changes.size(), first->changes.size());
    for (std::size_t i = 0; i < first->changes.size(); ++i) {
        EXPECT_EQ(again->changes[i].frame, first->changes[i].frame);
        EXPECT_EQ(inWords(again->changes[i]), inWords(first->changes[i]));
    }
    EXPECT_TRUE(read(R"({"name": "old"})")->changes.empty());
    EXPECT_FALSE(writeSolution(*read(R"({"name": "old"})")).contains("changes"));
}

TEST(Changes, SayWhatIsWrongWithThem) {
    struct Case {
        char const* entry;
        char const* says;
    };
    for (Case const& c :
         {Case{R"({"frame": 0, "detail": {"gravity": "tree"}})", "/changes/0/frame"},
          Case{R"({"detail": {"gravity": "tree"}})", "frame"},
          Case{R"({"frame": 1})", "does not say what was changed"},
          Case{R"({"frame": 1, "detail": {"a": "b"}, "period": {"c": 2}})", "several kinds"},
          Case{R"({"frame": 1, "detail": {}})", "changes nothing"},
          Case{R"({"frame": 1, "detail": {"gravity": 3}})", "/changes/0/detail/gravity"},
          Case{R"({"frame": 1, "period": {"Buoyancy": 0}})", "/changes/0/period/Buoyancy"},
          Case{R"({"frame": 1, "period": {"Buoyancy": 1.5}})", "/changes/0/period/Buoyancy"},
          Case{R"({"frame": 1, "setting": {"solver": 3}})", "/changes/0/setting/solver"},
          Case{R"({"frame": 1, "setting": {"solver": {"substeps": "x"}}})", "substeps"},
          Case{R"({"frame": 1, "detial": {"gravity": "tree"}})", "detial"}, Case{R"(7)", "/changes/0"}}) {
        std::vector<std::string> wrong;
        EXPECT_FALSE(read(std::string(R"({"name": "n", "changes": [)") + c.entry + "]}", &wrong)) << c.entry;
        std::string all;
        for (std::string const& line : wrong) {
            all += line + "\n";
        }
        EXPECT_NE(all.find(c.says), std::string::npos) << c.entry << " says: " << all;
    }
}

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

TEST_F(ChangesInALevel, OfWhatThereIsNotAreRefusedByName) {
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

TEST_F(ChangesInALevel, CountFromTheirFrameOnAndAreGoneWithTheRun) {
    open("4-raft.json");
    RecordedChange const change = make(Kind::setting, "solver", "substeps", 2);
    session().change(change);
    EXPECT_TRUE(session().changes().empty()) << "nothing runs yet";
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

// What the player turns while it runs, and what was turned before it began, is part of what is kept.
TEST_F(ChangesInALevel, ARecordedRunRepeatsWithWhatThePlayerTurned) {
    std::vector<std::uint64_t> hashes;
    Solution solution;
    {
        open("4-raft.json");
        session().setDetail("buoyancy", "particles");
        session().setPeriod("Liquid Drag", 3); // a bare name
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
        solution = *read(writeSolution(session().record("kept")).dump());
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
    EXPECT_NE(world().stateHash(), hashes[0]) << "so the changes do make a difference";
}

} // namespace
} // namespace trembler
