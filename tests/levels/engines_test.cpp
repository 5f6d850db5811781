// Every level of the thesis on every engine: recorded solutions solve it, recorded failures fail.
#include "puzzle/solutions/verify.hpp"
#include "tests/support/experiment.hpp"
#include "tests/support/motor_kit.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>

namespace trembler {
namespace {

std::vector<std::string> otherEngines() {
    std::vector<std::string> found;
    GameData const gameData;
    for (Registration const& registration : gameData.registry.components()) {
        ComponentText const& text = registration.info->text;
        if (text.effect == "dynamics" && !text.level.empty() && text.level != "box2d" &&
            registration.missing.empty()) {
            found.emplace_back(text.level);
        }
    }
    return found;
}

struct OnEngine {
    std::string engine;
    std::string level;
};

/// Reads only the JSON, as every process of this program does this for every level.
bool statesItsEngine(std::filesystem::path const& level) {
    std::ifstream file(level);
    nlohmann::json const read = nlohmann::json::parse(file);
    return read.contains(nlohmann::json::json_pointer("/world/detail/dynamics"));
}

std::vector<OnEngine> everyCase() {
    std::vector<OnEngine> cases;
    GameData const gameData;
    for (std::string const& engine : otherEngines()) {
        for (std::filesystem::path const& level : gameData.levels()) {
            if (statesItsEngine(level)) {
                continue; // it depends on how that engine computes contacts
            }
            cases.push_back({engine, gameData.shortName(level)});
        }
    }
    return cases;
}

class Engines : public Experiment, public ::testing::WithParamInterface<OnEngine> {};

TEST_P(Engines, VerifyTheLevel) {
    std::vector<std::string> const failures =
        verifyLevel(gameData(), gameData().home / GetParam().level, {{"dynamics", GetParam().engine}});
    for (std::string const& failure : failures) {
        ADD_FAILURE() << failure;
    }
}

// A motor runs steadily although another engine computes its bodies every two seconds.
TEST_F(Experiment, AMotorKeepsTurningWhileEnginesSwap) {
    std::vector<std::string> engines = otherEngines();
    engines.emplace_back("box2d");
    open("3-electric-motor.json");
    Tachometer tachometer(world());
    for (std::size_t swap = 0; swap < 12; ++swap) {
        session().setDetail("dynamics", engines[swap % engines.size()]);
        double const before = tachometer.turns();
        for (int frame = 0; frame < 240; ++frame) {
            step();
            tachometer.look(world());
        }
        if (swap > 1) { // it has started by then
            EXPECT_GT(tachometer.turns() - before, 0.5) << engines[swap % engines.size()];
        }
    }
    EXPECT_TRUE(session().solved());
}

INSTANTIATE_TEST_SUITE_P(All, Engines, ::testing::ValuesIn(everyCase()), [](auto const& info) {
    std::string name = info.param.engine + "_" + std::filesystem::path(info.param.level).stem().string();
    std::replace_if(
        name.begin(), name.end(), [](char c) { return std::isalnum(c) == 0; }, '_');
    return name;
});
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Engines);

} // namespace
} // namespace trembler
