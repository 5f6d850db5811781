// A frame in equal parts: its effect on components, periods, player input, traces and observers.
#include "runtime/frame/frame_resolver.hpp"
#include "runtime/population/population_resolver.hpp"
#include "tests/runtime/world/heat.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <sstream>

namespace trembler {
namespace parts_test {
namespace {

using namespace heat;

/// The events of a turn of the metronome, with their times.
struct Beats {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Beats", "beats", "The turns of the metronome."};
    static constexpr Coverage coverage = hashed;
    struct Beat {
        std::uint64_t frame = 0;
        double since = 0;    ///< s after the beginning of the frame, or part
        double duration = 0; ///< s
    };
    std::vector<Beat> beats;
    int ever = 0; ///< number of beats so far

    static void gather(Beats& frame, Beats const& part, PartSpan span) {
        frame.ever = part.ever;
        for (Beat beat : part.beats) {
            beat.since += span.begin;
            frame.beats.push_back(beat);
        }
    }
};
struct MetronomeRole {
    static constexpr std::string_view name = "Metronome";
    using Calls = CallList<>;
};
/// Reports one beat in each of its first turns, whose number is the greatest heat, and none afterwards.
struct Metronome final : Resolver<Metronome, MetronomeRole, Reads<Heat>, Writes<>, Provides<Beats>> {
    static constexpr ComponentText text{
        .name = "Metronome", .effect = "metronome", .level = "", .work = "Beats."};
    using Activation = NeedsAll<Heat>;
    static constexpr Coverage memory = leftOut("a test counts its turns");
    [[nodiscard]] bool restless() const { return left_ > 0 || told_; }
    void advance(Access& access) {
        if (access.provided<Beats>().ever == 0 && left_ < 0) {
            left_ = static_cast<int>(access.read<Heat>().values().front().value);
        }
        told_ = left_ > 0;
        if (left_-- >= 0) {
            Beats& beats = access.provide<Beats>();
            beats.beats.clear();
            if (told_) {
                ++beats.ever;
                beats.beats.push_back({access.frame(), 0.001, access.duration()});
            }
        }
    }

private:
    int left_ = -1;
    bool told_ = false;
};

struct Turns {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Turns", "turns", "How long the listener's turns were."};
    static constexpr std::string_view standing = "kept over all parts";
    static constexpr Coverage coverage = hashed;
    std::vector<double> durations; ///< s
};
struct ListenerRole {
    static constexpr std::string_view name = "Listener";
    using Calls = CallList<>;
};

/// Records the length of each turn. It has a turn if heat has changed.
struct Listener final : Resolver<Listener, ListenerRole, Reads<Heat>, Writes<>, Provides<Turns>> {
    static constexpr ComponentText text{
        .name = "Listener", .effect = "listener", .level = "", .work = "Listens."};
    using Activation = NeedsAll<Heat>;
    void advance(Access& access) { access.provide<Turns>().durations.push_back(access.duration()); }
};

/// Requests parts of at most 1/rate while there is fuel.
struct FrameFromFuel final : Interaction<FrameFromFuel, FrameRole, Reads<Fuel>> {
    static constexpr ComponentText text{
        .name = "Frame <- Fuel", .effect = "frame", .level = "", .work = "Splits frames."};
    using Activation = NeedsAll<Fuel>;
    void apply(Access& access) {
        forEach([&](ObjectId, Fuel const& fuel) { access.call(SplitFrame{1 / fuel.rate}); },
                access.read<Fuel>());
    }
};

Registry const& registry() {
    static Registry const shared = [] {
        Registry made;
        registerRuntime(made);
        made.component<Furnace>();
        made.component<Metronome>();
        made.component<ExactGlow>();
        made.component<HeatFromFuel>();
        made.component<FrameFromFuel>();
        return made;
    }();
    return shared;
}

ObjectId thing(World& world, std::string const& name, double heat, double fuel) {
    ObjectId const id = world.store().create(name);
    world.store().column<Heat>().set(id, {heat});
    if (fuel > 0) {
        world.store().column<Fuel>().set(id, {fuel});
    }
    return id;
}
/// The world's object states the number of parts.
void state(World& world, int parts) {
    Store& store = world.store();
    ObjectId const known = store.find("world");
    store.column<FrameSettings>().set(known.valid() ? known : store.create("world"), {parts});
}
void frames(World& world, int n) {
    for (int i = 0; i < n; ++i) {
        world.step();
    }
}

TEST(FrameParts, EachPartIsATurnOfThatLength) {
    for (int const parts : {1, 2, 4, 8}) {
        World world(registry());
        ObjectId const coal = thing(world, "coal", 0, 60);
        state(world, parts);
        world.start();
        frames(world, 3);
        EXPECT_EQ(world.frame(), 3U);
        EXPECT_DOUBLE_EQ(world.time(), 3 * frameDuration);
        EXPECT_EQ(world.find<FrameParts>()->parts, parts);
        EXPECT_EQ(statusOf(world, "Furnace").updates, 3U * static_cast<unsigned>(parts));
        EXPECT_DOUBLE_EQ(world.find<StoveLog>()->duration, frameDuration / parts);
        // The fire is passed on at the end of the first part and burns from the second one on, at 1 J a
        // frame.
        EXPECT_NEAR(world.find<Heat>(coal)->value, 3 - 1.0 / parts, 1e-12) << parts;
    }
}

TEST(FrameParts, OddNumbersAreRoundedUp) {
    for (auto const& [stated, expected] : {std::pair(3, 4), {5, 8}, {7, 8}, {8, 8}, {1000, 8}, {-3, 1}}) {
        World world(registry());
        state(world, stated);
        world.start();
        world.step();
        EXPECT_EQ(world.find<FrameParts>()->parts, expected) << stated;
    }
}

TEST(FrameParts, AreAsShortAsTheShortestRequest) {
    World world(registry());
    ObjectId const slow = thing(world, "slow", 0, 30);
    ObjectId const fast = thing(world, "fast", 0, 200);
    world.start();
    world.step();
    EXPECT_EQ(world.find<FrameParts>()->parts, 1) << "there are no requests before the first frame";
    world.step();
    EXPECT_EQ(world.find<FrameParts>()->parts, 4) << "200/s are 3.3 in a frame";
    world.store().column<Fuel>().set(fast, {70});
    world.step();
    EXPECT_EQ(world.find<FrameParts>()->parts, 4)
        << "a frame keeps its number of parts; requests count from the next one on";
    world.step();
    EXPECT_EQ(world.find<FrameParts>()->parts, 2);
    world.store().column<Fuel>().remove(fast);
    frames(world, 2);
    EXPECT_EQ(world.find<FrameParts>()->parts, 1);
    world.store().column<Fuel>().set(slow, {1e9});
    frames(world, 2);
    EXPECT_EQ(world.find<FrameParts>()->parts, 8) << "the greatest number of parts";
    state(world, 2);
    world.step();
    EXPECT_EQ(world.find<FrameParts>()->parts, 2) << "a stated number overrides requests";
    state(world, FrameSettings::automatic);
    for (double const nonsense :
         {0.0, -5.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        world.store().column<Fuel>().set(slow, {nonsense});
        frames(world, 2);
        EXPECT_EQ(world.find<FrameParts>()->parts, 1) << nonsense;
    }
}

TEST(FrameParts, APeriodCountsFrames) {
    for (int const parts : {1, 4}) {
        World world(registry());
        thing(world, "coal", 0, 60);
        state(world, parts);
        world.setPeriod("Furnace Resolver", 3);
        world.start();
        std::vector<double> durations;
        for (int frame = 1; frame <= 9; ++frame) {
            int last = 0;
            int part = 0;
            world.step([&](World const& inside) {
                ++part;
                if (auto const turns = static_cast<int>(statusOf(inside, "Furnace").updates);
                    turns > static_cast<int>(durations.size())) {
                    durations.push_back(inside.find<StoveLog>()->duration);
                    last = part;
                }
            });
            EXPECT_EQ(last, frame % 3 == 1 ? part : 0) << "one turn, in the last part of every third frame";
        }
        ASSERT_EQ(durations.size(), 3U);
        EXPECT_DOUBLE_EQ(durations[0], frameDuration);
        EXPECT_DOUBLE_EQ(durations[1], 3 * frameDuration);
        EXPECT_DOUBLE_EQ(durations[2], 3 * frameDuration);
    }
}

// Parts in which all components sleep are skipped. A component that wakes in the last part slept in the
// skipped ones.
TEST(FrameParts, AComponentThatWakesAfterSkippedPartsHasATurnOfOnePart) {
    for (bool const somebodyIsBusy : {false, true}) {
        Registry made;
        registerRuntime(made);
        made.component<Furnace>();
        made.component<Metronome>();
        made.component<Listener>();
        World world(made);
        thing(world, "coal", somebodyIsBusy ? 1000 : 0, 0); // turns of the metronome, in all parts
        state(world, 8);
        world.setPeriod("Furnace Resolver", 2);
        world.start();
        frames(world, 5);
        // First, and then after the furnace's turns in the last parts of frames 1, 3 and 5.
        EXPECT_EQ(world.find<Turns>()->durations, std::vector<double>(4, frameDuration / 8))
            << somebodyIsBusy;
        EXPECT_EQ(statusOf(world, "Metronome").updates > 8, somebodyIsBusy);
    }
}

TEST(FrameParts, PlayerInputIsTakenInTheFirst) {
    World world(registry());
    ObjectId const coal = thing(world, "coal", 0, 0);
    ObjectId const box = thing(world, "box", 0, 0);
    world.store().column<Position>().set(box, {{1, 2}});
    state(world, 4);
    world.start();
    world.step();
    world.feed({.kind = PlayerInput::Kind::remove, .object = coal, .other = {}, .at = {}});
    world.feed({.kind = PlayerInput::Kind::grab, .object = box, .other = {}, .at = {1, 2}});
    std::vector<std::size_t> removals;
    std::vector<bool> alive;
    world.step([&](World const& inside) {
        removals.push_back(inside.find<PlayerCommands>()->removals.size());
        alive.push_back(inside.store().alive(coal));
    });
    EXPECT_EQ(removals, (std::vector<std::size_t>{1, 0, 0, 0}));
    EXPECT_EQ(alive, (std::vector<bool>{true, false, false, false}));
    EXPECT_EQ(world.find<PlayerCommands>()->removals.size(), 1U)
        << "at the frame's end it is that of the whole frame";
    ASSERT_EQ(world.find<PopulationChanges>()->destroyed.size(), 1U);
    EXPECT_EQ(world.find<Hand>()->object, box);
    world.step();
    EXPECT_TRUE(world.find<PlayerCommands>()->removals.empty());
    EXPECT_TRUE(world.find<PopulationChanges>()->destroyed.empty());
}

TEST(FrameParts, TheNewsOfAFrameAreThoseOfAllItsParts) {
    for (int const parts : {1, 2, 4, 8}) {
        World world(registry());
        thing(world, "coal", 6, 0); // six beats
        state(world, parts);
        world.start();
        int received = 0;
        int receivedInside = 0;
        for (int frame = 1; frame <= 8; ++frame) {
            world.step([&](World const& inside) {
                std::size_t const now = inside.find<Beats>()->beats.size();
                EXPECT_LE(now, 1U) << "within a frame only the events of the part";
                receivedInside += static_cast<int>(now);
            });
            Beats const& beats = *world.find<Beats>();
            EXPECT_EQ(beats.ever, std::min(6, frame * parts));
            for (std::size_t i = 0; i < beats.beats.size(); ++i) {
                EXPECT_EQ(beats.beats[i].frame, world.frame());
                EXPECT_DOUBLE_EQ(beats.beats[i].duration, frameDuration / parts);
                EXPECT_NEAR(beats.beats[i].since, 0.001 + static_cast<double>(i) * frameDuration / parts,
                            1e-12);
            }
            received += static_cast<int>(beats.beats.size());
        }
        EXPECT_EQ(received, 6) << parts;
        EXPECT_EQ(receivedInside, 6) << parts;
    }
}

TEST(FrameParts, SleepingComponentsHaveNoTurnInAnyPart) {
    World world(registry());
    thing(world, "stone", 0, 0);
    state(world, 8);
    world.start();
    frames(world, 2);
    ComponentStatus const before = statusOf(world, "Exact Glow");
    std::vector<std::uint32_t> looks;
    world.setPeriod("Furnace Resolver", 3600); // the only restless component
    world.step([&](World const& inside) { looks.push_back(inside.moment().part); });
    EXPECT_EQ(looks, (std::vector<std::uint32_t>{1, 8})) << "the parts in between are skipped";
    EXPECT_EQ(statusOf(world, "Exact Glow").updates, before.updates);
    EXPECT_EQ(statusOf(world, "Exact Glow").activity, Activity::asleep);
}

TEST(FrameParts, TraceStatesFrameAndPart) {
    World world(registry(), {.threads = 1, .detail = {}, .periods = {}, .trace = true});
    thing(world, "coal", 0, 60);
    state(world, 2);
    world.start();
    world.step();
    world.store().column<Fuel>().set(world.store().find("coal"), {30});
    state(world, 1);
    frames(world, 2);
    auto const events = world.tracer()->events();
    for (std::size_t i = 1; i < events.size(); ++i) {
        EXPECT_LT(events[i - 1].id, events[i].id);
        EXPECT_LE(std::tie(events[i - 1].frame, events[i - 1].part),
                  std::tie(events[i].frame, events[i].part));
    }
    std::ostringstream written;
    world.tracer()->write(written);
    std::istringstream lines(written.str());
    std::vector<nlohmann::json> parsed;
    for (std::string line; std::getline(lines, line);) {
        parsed.push_back(nlohmann::json::parse(line));
    }
    ASSERT_EQ(parsed.size(), events.size());
    for (nlohmann::json const& line : parsed) {
        EXPECT_EQ(line.contains("part"), line.at("frame") == 1 && line.at("component") != "Frame") << line;
    }
    EXPECT_EQ(parsed.front().at("event"), "frame in 2 parts");
    ObjectId const none;
    world.note("Goals", "looked", std::span(&none, 0), {});
    EXPECT_EQ(world.tracer()->events().back().frame, 3U);
}

// A hundred burning objects, in chunks and on threads; some request other parts when their fuel changes.
std::vector<std::uint64_t> hashes(int threads, int parts) {
    WorldOptions options;
    options.threads = threads;
    options.rowsWorthThreads = 0;
    options.trace = threads % 2 == 0;
    World world(registry(), options);
    for (int i = 0; i < 3000; ++i) {
        thing(world, "thing " + std::to_string(i), i % 7, i % 3 == 0 ? 1 + i % 200 : 0);
    }
    state(world, parts);
    world.start();
    std::vector<std::uint64_t> found;
    for (int frame = 0; frame < 20; ++frame) {
        if (parts == FrameSettings::automatic) {
            double const rate = 50.0 * (1 + frame % 11);
            world.store().column<Fuel>().set(world.store().find("thing 0"), {rate});
        }
        world.step();
        found.push_back(world.stateHash());
    }
    return found;
}

TEST(FrameParts, DoNotDependOnThreads) {
    for (int const parts : {FrameSettings::automatic, 1, 2, 4, 8}) {
        auto const single = hashes(1, parts);
        for (int const threads : {2, 3, 8}) {
            EXPECT_EQ(single, hashes(threads, parts)) << threads << " threads, " << parts << " parts";
        }
        EXPECT_EQ(parts == 1, single == hashes(1, 1));
    }
}

TEST(FrameParts, AreOneWithoutTheResolverThatDividesFrames) {
    Registry alone;
    alone.component<Furnace>();
    World world(alone);
    thing(world, "coal", 0, 0);
    world.start();
    frames(world, 3);
    EXPECT_EQ(statusOf(world, "Furnace").updates, 3U);
}

} // namespace
} // namespace parts_test
} // namespace trembler
