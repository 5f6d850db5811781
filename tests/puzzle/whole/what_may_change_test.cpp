// While a level runs, a recording, the panel and the budget may only change how exactly it is computed; any
// other change is rejected with its place.
#include "physics/gravity/properties.hpp"
#include "puzzle/solutions/solution_file.hpp"
#include "puzzle/solutions/verify.hpp"
#include "runtime/level/model/world_change.hpp"
#include "runtime/level/property/field_outline.hpp"
#include "runtime/placement.hpp"
#include "tests/support/experiment.hpp"

#include <fstream>
#include <set>

namespace trembler {
namespace {

using Kind = RecordedChange::Kind;

RecordedChange make(Kind kind, std::string_view subject, std::string_view field, double value,
                    std::string level = {}) {
    RecordedChange change;
    change.kind = kind;
    change.subject = subject;
    change.field = field;
    change.value = value;
    change.level = std::move(level);
    return change;
}

/// Two discs without forces, and a solution that would make them attract each other.
std::string discs(std::string const& world, std::string const& changes) {
    return R"({
  "version": 2, "title": "two discs",
  "world": )" +
           world + R"(,
  "objects": [
    {"name": "a", "at": [-1, 0], "properties": {"shape": [{"form": "circle", "radius": 0.2}], "density": 5000}},
    {"name": "b", "at": [1, 0], "properties": {"shape": [{"form": "circle", "radius": 0.2}], "density": 5000}}],
  "goals": {"touching": ["a", "b"]},
  "solutions": [{"name": "pull", "frames": 600,
    "changes": [)" +
           changes + R"(]}]
})";
}

std::string refusalOf(std::function<void()> const& load) {
    try {
        load();
    } catch (InputError const& error) {
        std::string all;
        for (Diagnostic const& diagnostic : error.diagnostics()) {
            all += diagnostic.print() + "\n";
        }
        return all;
    }
    return "";
}

class WhatMayChange : public Experiment {
protected:
    [[nodiscard]] static std::string refusalOfLevel(std::string const& text) {
        return refusalOf([&] {
            LevelFile level = readLevel(gameData().registry, JsonDocument::parse(text, "discs.json"));
            Solution const solution = level.solutions.front();
            Session session(gameData().registry, gameData().parts, std::move(level));
            session.load(solution);
        });
    }
};

TEST_F(WhatMayChange, ASolutionThatSetsTheLawOfGravityIsRefusedWithItsPlace) {
    std::string const cheat = discs(R"({"gravity_law": {"constant": 0}})",
                                    R"({"frame": 2, "setting": {"gravity_law": {"constant": 1}}})");
    std::string const said = refusalOfLevel(cheat);
    EXPECT_NE(said.find("discs.json:9:"), std::string::npos) << said;
    EXPECT_NE(said.find("/solutions/0/changes/0/setting/gravity_law/constant"), std::string::npos) << said;
    EXPECT_NE(said.find("physics"), std::string::npos) << said;
    EXPECT_NE(said.find("gravity_law.opening_angle (0 to 1)"), std::string::npos) << said;

    std::filesystem::path const file = std::filesystem::path(testing::TempDir()) / "discs.json";
    std::ofstream(file) << cheat;
    auto const failures = verifyLevel(gameData(), file);
    ASSERT_FALSE(failures.empty());
    EXPECT_NE(failures.front().find("/solutions/0/changes/0/setting/gravity_law/constant"), std::string::npos)
        << failures.front();

    // For a solution in a separate file the message has the lines of that file.
    std::filesystem::path const own = std::filesystem::path(testing::TempDir()) / "pull.json";
    std::ofstream(own) << "{\"name\": \"pull\", \"changes\": [\n"
                          "  {\"frame\": 2, \"setting\": {\"gravity_law\": {\"constant\": 1}}}]}";
    LevelFile const level =
        readLevel(gameData().registry,
                  JsonDocument::parse(discs("{}", R"({"frame": 2, "setting": {"solver": {"substeps": 2}}})"),
                                      "l.json"));
    std::string const ownSaid =
        refusalOf([&] { static_cast<void>(findOrLoadSolution(gameData().registry, level, own.string())); });
    EXPECT_NE(ownSaid.find("pull.json:2:"), std::string::npos) << ownSaid;
    std::filesystem::remove(file);
    std::filesystem::remove(own);
}

// The rule follows from descriptions, so every number of every property is tested.
TEST_F(WhatMayChange, OnlyAccuracySettingsOfAllPropertiesAreAccepted) {
    std::set<std::string> taken;
    std::size_t refused = 0;
    for (PropertyInfo const* info : gameData().registry.objectProperties()) {
        for (FieldOutline const& field : outlineOf(*info->makeValue())) {
            bool any = false;
            // Within the range of the field, at its ends and between them.
            for (double const share : {0.0, 1e-9, 1e-6, 1e-3, 0.5, 1.0}) {
                double const from = std::max(field.info.minimum, -1e6);
                double value = from + share * (std::min(field.info.maximum, 1e6) - from);
                value = field.type == FieldType::integer ? std::floor(value) : value;
                any = any || !faultIn(gameData().registry,
                                      make(Kind::setting, info->text.key, field.info.key, value));
            }
            if (any) {
                taken.insert(std::string(info->text.key) + "." + std::string(field.info.key));
                EXPECT_TRUE(field.info.accuracy.any());
            } else {
                ++refused;
            }
        }
    }
    EXPECT_GT(refused, 50U);
    std::set<std::string> const accuracy{"solver.substeps",
                                         "solver.velocity_iterations",
                                         "solver.position_iterations",
                                         "solver.scale",
                                         "buoyancy.particles",
                                         "gravity_law.opening_angle",
                                         "magnetism.opening_angle",
                                         "magnetism.cutoff",
                                         "magnetism.force_threshold",
                                         "frame.parts"};
    EXPECT_EQ(taken, accuracy);
}

// A cutoff of a millimetre would switch magnetism off, so not every value affects only the accuracy.
TEST_F(WhatMayChange, OnlyCutoffsThatKeepMagnetismAreAccepted) {
    auto const fault = [&](std::string_view field, double value) {
        return faultIn(gameData().registry, make(Kind::setting, "magnetism", field, value)).has_value();
    };
    EXPECT_TRUE(fault("cutoff", 0.001));
    EXPECT_FALSE(fault("cutoff", 0)) << "automatic";
    EXPECT_FALSE(fault("cutoff", 4));
    EXPECT_TRUE(fault("force_threshold", 1e6));
    EXPECT_FALSE(fault("force_threshold", 0.001));
}

TEST_F(WhatMayChange, OnlyComponentsThatMaySkipFramesGetAPeriod) {
    std::set<std::string> able;
    for (Registration const& registration : gameData().registry.components()) {
        std::string const name = title(*registration.info);
        EXPECT_FALSE(faultIn(gameData().registry, make(Kind::period, name, "", registration.period)));
        EXPECT_TRUE(
            faultIn(gameData().registry, make(Kind::period, name, "", registration.longestPeriod + 1)));
        if (!faultIn(gameData().registry, make(Kind::period, name, "", 2))) {
            able.insert(name);
        }
    }
    EXPECT_TRUE(able.contains("Linear Gravity DPS"));
    EXPECT_TRUE(able.contains("Buoyancy Resolver"));
    EXPECT_FALSE(able.contains("Dynamics Resolver"));
    EXPECT_FALSE(able.contains("(Electricity <- Dynamics) Interaction")) << "a contact would be missed";
    EXPECT_FALSE(able.contains("Electricity Resolver"));
}

// Linear gravity and attraction between masses differ in physics, not only in accuracy.
TEST_F(WhatMayChange, ADetailLevelMustComputeWhatTheLevelStates) {
    std::string const both = R"({"gravity": [0, -9.81], "gravity_law": {"constant": 1e-3}})";
    std::string const said = refusalOfLevel(discs(both, R"({"frame": 2, "detail": {"gravity": "linear"}})"));
    EXPECT_NE(said.find("/solutions/0/changes/0/detail/gravity"), std::string::npos) << said;
    EXPECT_NE(said.find("'real', 'tree'"), std::string::npos) << said;
    EXPECT_EQ(refusalOfLevel(discs(both, R"({"frame": 2, "detail": {"gravity": "tree"}})")), "");
    // A level file may state linear gravity nevertheless; it then keeps it.
    std::string const stated =
        R"({"gravity": [0, -9.81], "gravity_law": {"constant": 1e-3}, "detail": {"gravity": "linear"}})";
    EXPECT_EQ(refusalOfLevel(discs(stated, R"({"frame": 2, "detail": {"gravity": "linear"}})")), "");
    EXPECT_NE(refusalOfLevel(discs(stated, R"({"frame": 2, "detail": {"gravity": "real"}})")), "");
    EXPECT_NE(refusalOfLevel(discs(stated, R"({"frame": 2, "detail": {"gravity": ""}})")), "");
}

TEST_F(WhatMayChange, ACircuitWithAReturnKeepsIt) {
    open("1-switched-electromagnet.json");
    runTo(2);
    EXPECT_THROW(session().setDetail("electricity", "single-cable"), std::invalid_argument);
    EXPECT_THROW(session().setDetail("electricity", "flow"), std::invalid_argument);
    EXPECT_NO_THROW(session().setDetail("electricity", "nodal"));
    EXPECT_NO_THROW(session().setDetail("electricity", "two-wire"));
    EXPECT_NO_THROW(session().setDetail("electricity", ""));
    EXPECT_THROW(session().setPeriod("Dynamics", 2), std::invalid_argument);
    EXPECT_NO_THROW(session().setPeriod("Linear Gravity", 2));
    EXPECT_THROW(session().change(make(Kind::setting, "gravity", "value", 0)), std::invalid_argument);
    EXPECT_EQ(session().changes().size(), 4U);
}

// The command line may choose other physics, but such a run cannot be saved as a solution.
TEST_F(WhatMayChange, ARunWithOtherPhysicsIsNoSolution) {
    LevelFile const level = load("1-switched-electromagnet.json");
    Session other(gameData().registry, gameData().parts, level,
                  {.detail = {{"electricity", "single-cable"}}, .periods = {}});
    EXPECT_TRUE(other.whyNotRecorded());
    other.step();
    EXPECT_TRUE(other.whyNotRecorded());
    Session exact(gameData().registry, gameData().parts, level,
                  {.detail = {{"electricity", "nodal"}}, .periods = {}});
    EXPECT_FALSE(exact.whyNotRecorded());
    Session slow(gameData().registry, gameData().parts, level,
                 {.detail = {}, .periods = {{"Dynamics Resolver", 2}}});
    EXPECT_TRUE(slow.whyNotRecorded());
}

} // namespace
} // namespace trembler
