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
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <utility>
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

/// The registry and the parts of a program without an effect.
struct Without {
    explicit Without(std::string name) : effect(std::move(name)) {
        registerEffects(registry, {effect});
        registry.check();
        parts = loadParts(registry, gameData().home / "assets" / "parts");
    }

    std::string effect;
    Registry registry;
    PartLibrary parts;
};

// The levels in six parts, so that several processors can share them; each is played with all effects once.
constexpr std::size_t shares = 6;
class LeftOut : public Experiment, public ::testing::WithParamInterface<std::size_t> {};

TEST_P(LeftOut, EveryLevelLoadsAndLevelsWithoutTheEffectEndInTheSameState) {
    std::vector<std::unique_ptr<Without>> programs;
    for (std::string const& effect : dispensableGameEffects()) {
        programs.push_back(std::make_unique<Without>(effect));
    }
    ASSERT_GT(programs.size(), 4U);
    std::vector<std::filesystem::path> const paths = gameData().levels();
    ASSERT_GT(paths.size(), shares);
    for (std::size_t i = GetParam(); i < paths.size(); i += shares) {
        Outcome const whole =
            play(loadLevel(gameData().registry, paths[i]), gameData().registry, gameData().parts);
        for (auto const& program : programs) {
            SCOPED_TRACE(paths[i].string() + " without " + program->effect);
            Outcome const rest =
                play(loadWithout(program->registry, paths[i]), program->registry, program->parts);
            EXPECT_FALSE(rest.atWork.contains(program->effect));
            EXPECT_TRUE(rest.atWork.contains("dynamics"));
            if (!whole.atWork.contains(program->effect)) {
                // The state hash may differ: the level may state properties of the effect, such as a
                // susceptibility.
                EXPECT_EQ(whole.motion, rest.motion);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Share, LeftOut, ::testing::Range(std::size_t{0}, shares));

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
