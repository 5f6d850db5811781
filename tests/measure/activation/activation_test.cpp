// Activation in every level: absent components are never constructed, components without changes sleep, and a
// level at rest causes almost no work. Work is counted in turns: no clock is read.
#include "measure/activation/activation.hpp"
#include "measure/activation/report.hpp"
#include "physics/buoyancy/properties/results.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/graph.hpp"
#include "puzzle/data/effects.hpp"
#include "puzzle/session/session.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/model/part_library.hpp"
#include "runtime/level/read/read_part.hpp"
#include "tests/support/experiment.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>
#include <utility>

namespace trembler {
namespace {

constexpr int seconds = 20;

// Instance counters: every component of a registry is made by one of these functions, which count and call
// the original one.
constexpr std::size_t mostComponents = 128;
std::array<std::function<std::unique_ptr<Component>()>, mostComponents> realMakers{};
std::array<int, mostComponents> made{};

template <std::size_t n>
std::unique_ptr<Component> countingMaker() {
    ++made[n];
    return realMakers[n]();
}
template <std::size_t... n>
constexpr auto countingMakers(std::index_sequence<n...>) {
    return std::array<std::unique_ptr<Component> (*)(), sizeof...(n)>{&countingMaker<n>...};
}

// All effects. The registry belongs to this function and is not constant, so its makers may be replaced.
Registry& countedRegistry() {
    static Registry registry;
    static bool const counted = [] {
        registerEffects(registry);
        auto const makers = countingMakers(std::make_index_sequence<mostComponents>{});
        std::size_t n = 0;
        for (Registration const& registration : registry.components()) {
            auto& open =
                const_cast<Registration&>(registration); // NOLINT(cppcoreguidelines-pro-type-const-cast)
            realMakers.at(n) = open.make;
            open.make = makers.at(n);
            ++n;
        }
        return true;
    }();
    static_cast<void>(counted);
    return registry;
}

std::map<std::string, int> constructions() {
    std::map<std::string, int> all;
    std::size_t n = 0;
    for (Registration const& registration : countedRegistry().components()) {
        all[title(*registration.info)] = made.at(n++);
    }
    return all;
}

// The keys of object properties, of which an effect needs at least one in the level. They are listed here and
// not taken from the declarations, because the declarations are tested.
std::map<std::string, std::set<std::string>> const& triggers() {
    static std::map<std::string, std::set<std::string>> const all{
        {"magnetism", {"magnet", "magnetic_poles", "electromagnet"}},
        {"electricity", {"conductor"}},
        {"buoyancy", {"liquid", "air", "in_air"}},
        {"motor", {"electric_motor", "generator"}},
        {"sound", {"sound_sensor", "ear"}}, // here nothing outside the world listens
        {"loudness", {"sound_sensor", "ear"}},
    };
    return all;
}

constexpr std::uint64_t mostParts = 8; // of a frame

/// Whether the level was made for measurements; in puzzles balls may roll and wheels turn for ever.
bool isMeasured(std::string const& level) {
    return level.find("levels/experiments/") != std::string::npos ||
           level.find("levels/sound/") != std::string::npos ||
           level.find("1-first-contact") != std::string::npos;
}

class Activation : public Experiment {
protected:
    static std::vector<LevelUse> const& plays() {
        static std::vector<LevelUse> const all = playAllForCalls(gameData(), seconds);
        return all;
    }
    static LevelUse const& play(std::string const& level, std::string const& solution) {
        for (LevelUse const& one : plays()) {
            if (one.level.find(level) != std::string::npos && one.solution == solution) {
                return one;
            }
        }
        throw std::logic_error("no such play: " + level + ", " + solution);
    }
    static ComponentUse const& use(LevelUse const& play, std::string const& component) {
        for (ComponentUse const& one : play.components) {
            if (title(*one.info) == component) {
                return one;
            }
        }
        throw std::logic_error("no such component: " + component);
    }
};

TEST_F(Activation, AllLevelsAreInTheTable) {
    std::set<std::string> levels;
    for (LevelUse const& one : plays()) {
        levels.insert(one.level);
        EXPECT_EQ(one.components.size(), gameData().registry.components().size());
        EXPECT_EQ(one.frames, seconds * framesPerSecond);
        std::uint64_t last = 0;
        for (ComponentUse const& each : one.components) {
            last += each.updatesInLastSecond;
            // A turn for each part of a frame; there are more than one where strong magnets need them.
            EXPECT_LE(each.updatesInLastSecond, mostParts * framesPerSecond);
            EXPECT_LE(each.updates, mostParts * one.frames) << title(*each.info) << ": too many turns";
        }
        EXPECT_EQ(last, one.lastSecond);
        EXPECT_LE(one.lastSecond, one.busiestSecond);
        EXPECT_GT(one.busiestSecond, 0U);
    }
    EXPECT_EQ(levels.size(), gameData().levels().size());
}

TEST_F(Activation, AbsentComponentsAreNeverConstructed) {
    PartLibrary const parts = loadParts(countedRegistry(), gameData().home / "assets" / "parts");
    std::map<std::string, int> with;
    std::map<std::string, int> without;
    for (std::filesystem::path const& path : gameData().levels()) {
        SCOPED_TRACE(path);
        LevelFile const level = loadLevel(countedRegistry(), path);
        made.fill(0);
        std::vector<Placement> placements;
        if (!level.solutions.empty()) {
            placements = level.solutions.front().placements;
        }
        auto const world = buildWorld(countedRegistry(), level, parts, placements,
                                      WorldOptions{.threads = 1, .detail = level.detail, .periods = {}});
        for (int frame = 0; frame < 240; ++frame) {
            world->step();
        }
        auto const counts = constructions();
        auto const holds = [&](std::string const& key) {
            auto const* const info = countedRegistry().objectProperty(key);
            auto const* const column = info == nullptr ? nullptr : world->store().findColumn(*info);
            return column != nullptr && !column->empty();
        };
        std::set<PropertyInfo const*> offered;
        for (ComponentStatus const& status : world->status()) {
            std::string const name = title(*status.info);
            bool const there = status.activity != Activity::absent;
            EXPECT_EQ(counts.at(name), there ? 1 : 0) << name;
            if (there) {
                offered.insert(status.info->offers.begin(), status.info->offers.end());
            } else {
                EXPECT_EQ(status.updates, 0U) << name;
            }
            auto const needs = triggers().find(std::string(status.info->text.effect));
            if (needs != triggers().end()) {
                bool const called = std::any_of(needs->second.begin(), needs->second.end(), holds);
                EXPECT_FALSE(there && !called) << name << " is constructed although no object activates it";
                ++(called ? with : without)[needs->first];
            }
        }
        // It has not even a slot for its results, except for the initial gravity of a world, which liquids
        // that are created later need at once.
        for (ComponentStatus const& status : world->status()) {
            for (PropertyInfo const* const offer : status.info->offers) {
                EXPECT_TRUE(offered.contains(offer) || world->store().findSlot(*offer) == nullptr ||
                            offer == &propertyInfo<LinearGravityVector>())
                    << title(*status.info) << " left " << offer->text.name;
            }
        }
    }
    for (auto const& [effect, keys] : triggers()) {
        if (effect != "loudness") {
            EXPECT_GT(with[effect], 0) << "no level activates " << effect << ": nothing was tested";
            EXPECT_GT(without[effect], 0) << "every level activates " << effect << ": nothing was tested";
        }
    }
}

TEST_F(Activation, ALevelAtRestHasAtMostATwentiethOfTheTurnsOfMotion) {
    int atRest = 0;
    std::set<std::string> restless;
    for (LevelUse const& one : plays()) {
        if (!isMeasured(one.level)) {
            continue;
        }
        if (!one.atRest) {
            restless.insert(one.level + ", " + one.solution);
            continue;
        }
        ++atRest;
        EXPECT_LE(static_cast<double>(one.lastSecond), 0.05 * static_cast<double>(one.busiestSecond))
            << one.level << ", " << one.solution;
    }
    EXPECT_GE(atRest, 12) << "of " << plays().size();
    // Only these levels never come to rest: ringing bells, motors, and, as there is no rolling resistance,
    // balls that roll on the floor.
    for (std::string const& each : restless) {
        bool const meantTo = each.find("doorbell") != std::string::npos ||
                             each.find("experiments/3") != std::string::npos ||
                             each.find("rubber rings no bell") != std::string::npos ||
                             each.find("one ball from the board") != std::string::npos;
        EXPECT_TRUE(meantTo) << each;
    }
}

TEST_F(Activation, AFinishedCircuitsDpsSleeps) {
    // The magnet holds the lifted object: current flows, but is not computed again.
    open("1-switched-electromagnet.json", "hands off");
    runTo(900);
    ASSERT_TRUE(on("electromagnet"));
    auto const dps = [&] {
        for (ComponentStatus const& status : world().status()) {
            if (title(*status.info) == "Two-wire Electricity DPS") {
                return status;
            }
        }
        return ComponentStatus{};
    };
    ComponentStatus const before = dps();
    EXPECT_EQ(before.activity, Activity::asleep);
    EXPECT_GT(before.updates, 0U);
    runTo(1500);
    EXPECT_TRUE(on("electromagnet"));
    EXPECT_EQ(dps().activity, Activity::asleep);
    EXPECT_EQ(dps().updates, before.updates);
}

// In a doorbell, which never rests, it has a turn only if the graph has changed.
TEST_F(Activation, ElectricityIsComputedWhenItsGraphHasChangedOnly) {
    open("2-doorbell.json");
    std::uint64_t version = 0;
    std::uint64_t changes = 0;
    std::uint64_t updates = 0;
    while (world().frame() < 1200) {
        step();
        std::uint64_t const now = world().store().findColumn<ElectricityGraph>()->version();
        changes += now != version ? 1 : 0;
        version = now;
    }
    for (ComponentStatus const& status : world().status()) {
        if (title(*status.info) == "Two-wire Electricity DPS") {
            updates = status.updates;
        }
    }
    EXPECT_GT(changes, 20U);
    EXPECT_LT(changes, 400U);
    EXPECT_EQ(updates, changes);
}

TEST_F(Activation, TheRaftRestsAndTheDoorbellDoesNot) {
    LevelUse const& raft = play("4-raft", "hands off");
    EXPECT_TRUE(raft.atRest);
    EXPECT_EQ(raft.lastSecond, 0U);
    EXPECT_EQ(use(raft, "Buoyancy Resolver").atEnd, Activity::asleep);
    EXPECT_GT(use(raft, "Buoyancy Resolver").updates, 60U);
    EXPECT_EQ(use(raft, "Magnetics Resolver").atEnd, Activity::absent);
    LevelUse const& bell = play("2-doorbell", "hands off");
    EXPECT_FALSE(bell.atRest);
    EXPECT_EQ(use(bell, "Dynamics Resolver").updates, bell.frames);
    EXPECT_EQ(use(bell, "Buoyancy Resolver").atEnd, Activity::absent);
}

TEST_F(Activation, TheReportsHaveEveryPlayAndNoTimes) {
    auto const json = nlohmann::json::parse(activationJson(plays()).dump());
    ASSERT_EQ(json.at("plays").size(), plays().size());
    std::uint64_t updates = 0;
    for (auto const& component : json.at("plays").at(0).at("components")) {
        updates += component.at("updates").get<std::uint64_t>();
    }
    std::uint64_t counted = 0;
    for (ComponentUse const& each : plays().front().components) {
        counted += each.updates;
    }
    EXPECT_EQ(updates, counted);
    std::string const markdown = activationMarkdown(plays());
    for (LevelUse const& one : plays()) {
        EXPECT_NE(markdown.find("| " + one.level + " | "), std::string::npos);
    }
    EXPECT_EQ(markdown.find(" us"), std::string::npos);
    // Every report is the same.
    LevelFile const level = loadLevel(gameData().registry, gameData().levels().front());
    Solution const* const first = level.solutions.empty() ? nullptr : &level.solutions.front();
    LevelUse again = playForCalls(gameData(), level, first, seconds);
    again.level = plays().front().level;
    EXPECT_EQ(activationText({again}), activationText({plays().front()}));
}

} // namespace
} // namespace trembler
