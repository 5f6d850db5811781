// Turns of components that sleep and wake, compared with a model that considers each of them in every part.
// The world itself skips the entries of components that stay asleep.
#include "runtime/frame/frame_resolver.hpp"
#include "runtime/population/population_resolver.hpp"
#include "tests/runtime/world/heat.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <optional>

namespace trembler {
namespace world_turns_test {
namespace {

using namespace heat;

struct TurnTaken {
    std::uint64_t frame = 0;
    double duration = 0; ///< s
    bool operator==(TurnTaken const&) const = default;
};

struct PulseKind {
    ComponentText text;
    std::vector<bool> pattern; ///< the turns, repeated for ever, in which it marks heat as changed
};
struct Pulse final : Resolver<Pulse, HeatRole, Reads<>, Writes<Heat>> {
    using Activation = NeedsAll<Heat>;
    static constexpr Coverage memory = leftOut("a test counts its turns");
    Pulse(ComponentInfo const& info, PulseKind const& kind) : Resolver(info), pattern_(kind.pattern) {}
    [[nodiscard]] bool restless() const { return true; }
    void advance(Access& access) {
        if (pattern_[turns_++ % pattern_.size()]) {
            (void)access.write<Heat>();
        }
    }

private:
    std::vector<bool> pattern_;
    std::size_t turns_ = 0;
};

/// The turns of the derived property set.
struct Diary {
    static constexpr PropertyKind kind = PropertyKind::derived;
    static constexpr PropertyText text{"Diary", "diary", "The turns so far."};
    std::vector<TurnTaken> turns;
};
struct DerivedDiary final : Dps<DerivedDiary, Reads<Heat, Fuel>, Derives<Diary>> {
    static constexpr ComponentText text{
        .name = "Derived Diary", .effect = "diary", .level = "", .work = "Notes its turns."};
    using Activation = NeedsAll<Heat>;
    void update(Access& access) {
        access.derive<Diary>().turns.push_back({access.frame(), access.duration()});
    }
};

struct ListenerKind {
    ComponentText text;
    std::vector<TurnTaken>* turns;
};
struct Listener final : Interaction<Listener, HeatRole, Reads<Heat, Fuel>> {
    using Activation = NeedsAll<Heat>;
    static constexpr Coverage memory = leftOut("a test's notes");
    Listener(ComponentInfo const& info, ListenerKind const& kind) : Interaction(info), turns_(kind.turns) {}
    void apply(Access& access) { turns_->push_back({access.frame(), access.duration()}); }

private:
    std::vector<TurnTaken>* turns_;
};

/// A component that reads heat and fuel, as the world would treat it if it looked at it in every part.
struct Model {
    int period = 1;
    bool changed = true; // as it has had no turn yet
    std::uint64_t last = 0;
    std::vector<TurnTaken> turns;
    bool active = false;

    void part(std::uint64_t frame, std::uint32_t part, std::uint32_t parts, bool pulse) {
        changed = changed || pulse;
        std::uint64_t const ticks =
            (frame - 1) * World::ticksPerFrame + part * (World::ticksPerFrame / parts);
        bool const due =
            period == 1 || (part == parts && (frame - 1) % static_cast<std::uint64_t>(period) == 0);
        if (!due) {
            return;
        }
        active = active && part != 1 && period == 1;
        if (changed) {
            turns.push_back(
                {frame, frameDuration * (static_cast<double>(ticks - last) / World::ticksPerFrame)});
            active = true;
        }
        changed = false;
        last = ticks;
    }
};

/// The changes before a frame.
struct Deed {
    bool touchFuel = false;
    bool watch = false;           ///< a subscription begins, or ends: all components are bound again
    bool create = false;          ///< an object with fuel
    std::optional<int> period;    ///< of both diaries from now on
    std::optional<int> resolvers; ///< the period of Pulse from now on
};

Deed deedOf(std::uint8_t byte) {
    Deed deed;
    deed.touchFuel = byte % 5 == 0;
    deed.watch = byte % 7 == 0;
    deed.create = byte % 31 == 0;
    if (byte % 6 == 0) {
        deed.period = 1 + byte / 6 % 3;
    }
    if (byte % 11 == 0) {
        deed.resolvers = 1 + byte / 11 % 3;
    }
    return deed;
}

void checkTurns(std::vector<std::uint8_t> const& deeds, std::vector<bool> const& pattern, int parts,
                int threads) {
    std::vector<TurnTaken> heard;
    PulseKind const pulse{{.name = "Pulse", .effect = "pulse", .level = "", .work = "Beats."}, pattern};
    ListenerKind const listener{
        {.name = "Heat <- Listener", .effect = "heat", .level = "", .work = "Listens."}, &heard};
    Registry registry;
    registerRuntime(registry);
    registry.component<Pulse>(pulse);
    registry.component<ExactGlow>();
    registry.component<DerivedDiary>();
    registry.component<Listener>(listener);
    WorldOptions options;
    options.threads = threads;
    options.rowsWorthThreads = 0;
    World world(registry, options);
    Store& store = world.store();
    ObjectId const coal = store.create("coal");
    store.column<Heat>().set(coal, {1});
    store.column<Fuel>().set(coal, {1});
    store.column<FrameSettings>().set(store.create("world"), {parts});
    world.start();
    Model model;
    int pulsePeriod = 1;
    std::size_t beats = 0;
    int created = 0;
    Subscription subscription;
    for (std::uint8_t const byte : deeds) {
        Deed const deed = deedOf(byte);
        if (deed.touchFuel) {
            store.column<Fuel>().touch();
            model.changed = true;
        }
        if (deed.create) {
            store.column<Fuel>().set(store.create("more " + std::to_string(++created)), {1});
            model.changed = true;
        }
        if (deed.watch) {
            subscription = subscription ? Subscription() : world.want<Glow>();
        }
        if (deed.period) {
            world.setPeriod("Heat <- Listener", *deed.period);
            world.setPeriod("Derived Diary", *deed.period);
            model.period = *deed.period;
        }
        if (deed.resolvers) {
            world.setPeriod("Pulse", *deed.resolvers);
            pulsePeriod = *deed.resolvers;
        }
        world.step();
        std::uint32_t const now = world.moment().parts;
        for (std::uint32_t part = 1; part <= now; ++part) {
            bool const beat =
                pulsePeriod == 1 ||
                (part == now && (world.frame() - 1) % static_cast<std::uint64_t>(pulsePeriod) == 0);
            model.part(world.frame(), part, now, beat && pattern[beats % pattern.size()]);
            beats += beat ? 1 : 0;
        }
        ASSERT_EQ(heard, model.turns);
        ASSERT_EQ(world.find<Diary>()->turns, model.turns);
        for (std::string_view const name : {"Heat <- Listener", "Derived Diary"}) {
            ComponentStatus const status = statusOf(world, name);
            ASSERT_EQ(status.activity, model.active ? Activity::active : Activity::asleep) << name;
            ASSERT_EQ(status.updates, model.turns.size()) << name;
        }
    }
}

TEST(WorldTurns, AreThoseOfAModelThatConsidersEveryComponentInEveryPart) {
    EXPECT_TRUE(rc::check([](std::vector<std::uint8_t> const& deeds) {
        std::vector<bool> const pattern = *rc::gen::nonEmpty(
            rc::gen::container<std::vector<bool>>(rc::gen::weightedElement<bool>({{4, false}, {1, true}})));
        int const parts = *rc::gen::element(1, 2, 4, 8);
        int const threads = *rc::gen::element(1, 2);
        checkTurns(deeds, pattern, parts, threads);
        RC_ASSERT(!testing::Test::HasFatalFailure());
    }));
}

// A rare change after long sleep, in each part of a frame.
TEST(WorldTurns, WakeInThePartInWhichSomethingChanges) {
    for (std::size_t const beat : {8U, 9U, 15U, 100U}) {
        std::vector<bool> pattern(128, false);
        pattern[beat] = true;
        checkTurns(std::vector<std::uint8_t>(40, 1), pattern, 8, 1);
        ASSERT_FALSE(HasFatalFailure()) << beat;
    }
}

} // namespace
} // namespace world_turns_test
} // namespace trembler
