// Any effect may be left out, and the others still work: simulations do not depend on each other.
#include "puzzle/data/effects.hpp"
#include "puzzle/session/session.hpp"
#include "runtime/level/model/part_library.hpp"
#include "tests/support/experiment.hpp"

#include <algorithm>

namespace trembler {
namespace {

struct Outcome {
    std::uint64_t hash = 0;
    std::set<std::string> atWork; ///< effects
};

Outcome play(LevelFile const& level, Registry const& registry, PartLibrary const& parts) {
    Session session(registry, parts, level,
                    WorldOptions{.threads = 1, .detail = level.detail, .periods = {}});
    Outcome outcome;
    for (int frame = 0; frame < 240; ++frame) {
        session.step();
    }
    outcome.hash = session.world().stateHash();
    for (ComponentStatus const& status : session.world().status()) {
        if (status.activity != Activity::absent) {
            outcome.atWork.emplace(status.info->text.effect);
        }
    }
    return outcome;
}

class LeftOut : public Experiment, public ::testing::WithParamInterface<std::string> {};

TEST_P(LeftOut, EveryLevelLoadsAndLevelsWithoutTheEffectEndInTheSameState) {
    Registry registry;
    registerEffects(registry, {GetParam()});
    registry.check();
    PartLibrary const parts = loadParts(registry, gameData().home / "assets" / "parts");
    int untouched = 0;
    for (std::filesystem::path const& path : gameData().levels()) {
        Outcome const whole =
            play(loadLevel(gameData().registry, path), gameData().registry, gameData().parts);
        Outcome const rest = play(loadLevel(registry, path), registry, parts);
        EXPECT_FALSE(rest.atWork.contains(GetParam())) << path;
        EXPECT_TRUE(rest.atWork.contains("dynamics")) << path;
        if (!whole.atWork.contains(GetParam())) {
            EXPECT_EQ(whole.hash, rest.hash) << path;
            ++untouched;
        }
    }
    RecordProperty("levels_that_do_not_call_for_it", untouched);
}

INSTANTIATE_TEST_SUITE_P(Each, LeftOut, ::testing::ValuesIn([] {
                             std::set<std::string> const all = dispensableGameEffects();
                             return std::vector<std::string>(all.begin(), all.end());
                         }()),
                         [](auto const& info) { return info.param; });

TEST_F(Experiment, AllEffectsButDynamicsCanBeLeftOutAtOnce) {
    Registry registry;
    registerEffects(registry, dispensableGameEffects());
    registry.check();
    PartLibrary const parts = loadParts(registry, gameData().home / "assets" / "parts");
    for (std::filesystem::path const& path : gameData().levels()) {
        Outcome const rest = play(loadLevel(registry, path), registry, parts);
        EXPECT_TRUE(rest.atWork.contains("dynamics")) << path;
    }
    EXPECT_THROW(registerEffects(registry, {"dynamics"}), std::invalid_argument);
}

} // namespace
} // namespace trembler
