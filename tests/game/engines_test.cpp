// Every level of the thesis on every engine: recorded solutions solve it, what is recorded as failing fails.
#include "game/session/verify.hpp"
#include "tests/game/experiment.hpp"

namespace trembler {
namespace {

std::vector<std::string> otherEngines() {
    std::vector<std::string> found;
    Workshop const workshop;
    for (Registration const& registration : workshop.registry.components()) {
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

std::vector<OnEngine> everyCase() {
    std::vector<OnEngine> cases;
    Workshop const workshop;
    for (std::string const& engine : otherEngines()) {
        for (std::filesystem::path const& level : workshop.levels()) {
            cases.push_back({engine, workshop.shortName(level)});
        }
    }
    return cases;
}

class Engines : public Experiment, public ::testing::WithParamInterface<OnEngine> {};

TEST_P(Engines, VerifyTheLevel) {
    std::vector<std::string> const failures =
        verifyLevel(workshop(), workshop().home / GetParam().level, {{"dynamics", GetParam().engine}});
    for (std::string const& failure : failures) {
        ADD_FAILURE() << failure;
    }
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
