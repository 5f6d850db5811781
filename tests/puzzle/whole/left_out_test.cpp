// Any effect may be left out, and the others still work: simulations do not depend on each other.
#include "physics/dynamics/properties/body.hpp"
#include "puzzle/data/effects.hpp"
#include "puzzle/session/session.hpp"
#include "runtime/level/json/json_document.hpp"
#include "runtime/level/model/part_library.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/level/read/read_part.hpp"
#include "runtime/placement.hpp"
#include "tests/support/experiment.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace trembler {
namespace {

/// The place and the velocity of every object.
using Motion = std::vector<std::tuple<std::string, Vec2, double, Vec2>>;

Motion motionOf(World const& world) {
    Motion motion;
    for (ObjectId const id : world.store().findColumn<Position>()->owners()) {
        auto const* const turned = world.find<Rotation>(id);
        auto const* const velocity = world.find<Velocity>(id);
        motion.emplace_back(world.store().nameOf(id), world.find<Position>(id)->value,
                            turned != nullptr ? turned->angle : 0,
                            velocity != nullptr ? velocity->value : Vec2{});
    }
    std::sort(motion.begin(), motion.end(),
              [](auto const& a, auto const& b) { return std::get<0>(a) < std::get<0>(b); });
    return motion;
}

struct Outcome {
    Motion motion;
    std::set<std::string> atWork; ///< effects
};

Outcome play(LevelFile const& level, Registry const& registry, PartLibrary const& parts) {
    Session session(registry, parts, level,
                    WorldOptions{.threads = 1, .detail = level.detail, .periods = {}});
    Outcome outcome;
    for (int frame = 0; frame < 240; ++frame) {
        session.step();
    }
    outcome.motion = motionOf(session.world());
    for (ComponentStatus const& status : session.world().status()) {
        if (status.activity != Activity::absent) {
            outcome.atWork.emplace(status.info->text.effect);
        }
    }
    return outcome;
}

/// A level may state how exactly an effect is computed; without the effect this line is removed.
LevelFile loadWithout(Registry const& registry, std::filesystem::path const& path) {
    std::set<std::string> chosen;
    for (Registration const& registration : registry.components()) {
        ComponentText const& text = registration.info->text;
        if (!text.level.empty()) {
            chosen.emplace(text.effect);
        }
    }
    std::ifstream file(path);
    nlohmann::ordered_json level = nlohmann::ordered_json::parse(file);
    nlohmann::ordered_json::json_pointer const place("/world/detail");
    if (level.contains(place)) {
        nlohmann::ordered_json kept = nlohmann::ordered_json::object();
        for (auto const& [effect, stated] : level.at(place).items()) {
            if (chosen.contains(effect)) {
                kept[effect] = stated;
            }
        }
        level.at(place) = std::move(kept);
    }
    return readLevel(registry, JsonDocument::parse(level.dump(1), path.string()));
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
        Outcome const rest = play(loadWithout(registry, path), registry, parts);
        EXPECT_FALSE(rest.atWork.contains(GetParam())) << path;
        EXPECT_TRUE(rest.atWork.contains("dynamics")) << path;
        if (!whole.atWork.contains(GetParam())) {
            // The state hash may differ: the level may state properties of the effect, such as a
            // susceptibility.
            EXPECT_EQ(whole.motion, rest.motion) << path;
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
        Outcome const rest = play(loadWithout(registry, path), registry, parts);
        EXPECT_TRUE(rest.atWork.contains("dynamics")) << path;
    }
    EXPECT_THROW(registerEffects(registry, {"dynamics"}), std::invalid_argument);
}

} // namespace
} // namespace trembler
