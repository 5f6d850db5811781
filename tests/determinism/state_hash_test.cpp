// Equal hashes mean equal worlds: changes every field of every property and every member of every slot and of
// every call in turn. The hash must change, unless the member is on the list of exceptions.
#include "audio/effect/calls.hpp"
#include "audio/effect/properties/acoustics.hpp"
#include "audio/effect/properties/sounds.hpp"
#include "physics/buoyancy/calls.hpp"
#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/buoyancy/properties/results.hpp"
#include "physics/dynamics/calls.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "physics/dynamics/properties/engine_state.hpp"
#include "physics/dynamics/properties/force_lag.hpp"
#include "physics/dynamics/properties/force_rates.hpp"
#include "physics/dynamics/properties/impacts.hpp"
#include "physics/dynamics/properties/motion_causes.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/dynamics/properties/solver_choice.hpp"
#include "physics/electricity/calls.hpp"
#include "physics/electricity/core/graph_changes.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/magnetism/calls.hpp"
#include "physics/magnetism/properties.hpp"
#include "physics/material.hpp"
#include "runtime/frame/calls.hpp"
#include "runtime/frame/frame_resolver.hpp"
#include "runtime/input/input_resolver.hpp"
#include "runtime/placement.hpp"
#include "runtime/population/population_resolver.hpp"
#include "runtime/property/idle_visitor.hpp"
#include "runtime/world/world.hpp"
#include "tests/determinism/level_runs.hpp"

#include <gtest/gtest.h>

#include <set>

namespace trembler::determinism {
namespace {

// ---- Fields of object properties, found through their descriptions.

// Changes the field with a given number; the fields of elements of lists are counted as well.
class ChangeField final : public FieldVisitor {
public:
    explicit ChangeField(int number) : left_(number) {}
    [[nodiscard]] bool done() const { return done_; }
    [[nodiscard]] std::string const& what() const { return what_; }

    void boolean(FieldInfo const& info, bool& v) override {
        if (mine(info)) {
            v = !v;
        }
    }
    void integer(FieldInfo const& info, std::int32_t& v) override {
        if (mine(info)) {
            ++v;
        }
    }
    void number(FieldInfo const& info, double& v) override {
        if (mine(info)) {
            v += 0.5;
        }
    }
    void vector(FieldInfo const& info, Vec2& v) override {
        if (mine(info)) {
            v.x += 0.5;
        }
        if (mine(info)) {
            v.y += 0.5;
        }
    }
    void text(FieldInfo const& info, std::string& v) override {
        if (mine(info)) {
            v += "x";
        }
    }
    void object(FieldInfo const& info, ObjectId& v) override {
        if (mine(info)) {
            v.index = v.index == 7 ? 8 : 7;
        }
        if (mine(info)) {
            ++v.generation;
        }
    }
    void choice(FieldInfo const& info, ChoiceField v) override {
        if (mine(info)) {
            v.index = v.index == 0 ? 1 : 0;
        }
    }
    void list(FieldInfo const& info, ListField& v) override {
        if (info.key == "by") {
            return; // the owners of a connection are a copy for display: see ElectricityConnections
        }
        if (mine(info)) {
            v.resize(v.size() + 1);
        }
        for (std::size_t i = 0; i < v.size(); ++i) {
            v.visitElement(i, *this);
        }
    }

private:
    bool mine(FieldInfo const& info) {
        if (done_ || left_-- > 0) {
            return false;
        }
        what_ = info.key;
        return done_ = true;
    }
    int left_;
    bool done_ = false;
    std::string what_;
};

// Puts one element into every list, so that there is one to change.
class FillLists final : public IdleVisitor {
public:
    void list(FieldInfo const&, ListField& v) override {
        if (v.size() == 0) {
            v.resize(1);
        }
        v.visitElement(0, *this);
    }
};

TEST(StateHashCovers, NoFieldOfAPropertyThatIsDeclaredAsLeftOut) {
    int leftOut = 0;
    for (PropertyInfo const* info : gameData().registry.objectProperties()) {
        if (info->coverage.kind != Coverage::Kind::leftOut) {
            continue;
        }
        ++leftOut;
        EXPECT_FALSE(info->coverage.reason.empty()) << info->text.name;
        World world(gameData().registry);
        ObjectId const id = world.store().create("thing");
        std::uint64_t const without = world.stateHash();
        world.store().column(*info).addDefault(id);
        FillLists fill;
        world.store().column(*info).visit(id, fill);
        EXPECT_EQ(world.stateHash(), without) << info->text.name;
    }
    EXPECT_EQ(leftOut, 1) << "the drawing alone";
}

// How a joint is drawn is a member that is left out.
bool leftOutOfHash(PropertyInfo const& info, std::string_view field) {
    return info.text.key == "joint" && field == "look";
}

TEST(StateHashCovers, EveryFieldOfEveryObjectProperty) {
    int fields = 0;
    for (PropertyInfo const* info : gameData().registry.objectProperties()) {
        if (info->coverage.kind == Coverage::Kind::leftOut) {
            continue;
        }
        World world(gameData().registry);
        ObjectId const id = world.store().create("thing");
        std::uint64_t const without = world.stateHash();
        world.store().column(*info).addDefault(id);
        FillLists fill;
        world.store().column(*info).visit(id, fill);
        if (info->text.key != Name::text.key) {
            EXPECT_NE(world.stateHash(), without) << "with and without " << info->text.name;
        }
        std::set<std::uint64_t> seen{world.stateHash()};
        for (int number = 0;; ++number) {
            World other(gameData().registry);
            ObjectId const twin = other.store().create("thing");
            other.store().column(*info).addDefault(twin);
            other.store().column(*info).visit(twin, fill);
            ChangeField change(number);
            other.store().column(*info).visit(twin, change);
            if (!change.done()) {
                break;
            }
            ++fields;
            EXPECT_NE(seen.insert(other.stateHash()).second, leftOutOfHash(*info, change.what()))
                << info->text.name << "." << change.what();
        }
    }
    EXPECT_GT(fields, 100);
}

// ---- Members of slots and calls, found by the compiler.

// Changes the leaf with a given number among the members of a value; returns whether it exists.
template <class T>
bool changeLeaf(T& v, int& left) {
    if constexpr (std::is_same_v<T, EventId>) {
        return false; // events of the trace: see EventsDoNotShow
    } else if constexpr (std::is_same_v<T, std::string>) {
        return left-- == 0 && (v += "x", true);
    } else if constexpr (std::is_same_v<T, bool>) {
        return left-- == 0 && (v = !v, true);
    } else if constexpr (std::is_enum_v<T>) {
        using Number = std::underlying_type_t<T>;
        return left-- == 0 && (v = static_cast<T>(static_cast<Number>(v) + Number{1}), true);
    } else if constexpr (std::is_arithmetic_v<T>) {
        return left-- == 0 && (v = static_cast<T>(v + T{1}), true);
    } else if constexpr (requires { v.emplace_back(); }) {
        if (left-- == 0) {
            v.emplace_back();
            return true;
        }
        if (v.empty()) {
            v.emplace_back();
        }
        return changeLeaf(v.front(), left);
    } else if constexpr (requires { v.begin(); }) { // std::array
        for (auto& element : v) {
            if (changeLeaf(element, left)) {
                return true;
            }
        }
        return false;
    } else if constexpr (requires { typename T::MembersOf; }) {
        return changeLeaf(static_cast<typename T::MembersOf&>(v), left);
    } else {
        bool done = false;
        forEachMember(v, [&](auto& member) { done = done || changeLeaf(member, left); });
        return done;
    }
}

// One object for every condition that activates a component, far from each other.
struct Everything {
    World world;

    explicit Everything(WorldOptions options = {}) : world(gameData().registry, std::move(options)) {
        auto& store = world.store();
        ObjectId const all = give("world", GravityField{{0, -9.81}});
        static_cast<void>(all);
        ObjectId const floor = give("floor", Shape{{boxPiece(20, 1)}});
        set(floor, Position{{0, -0.5}}, Fixed{}, Conductor{});
        ObjectId const ball = give("ball", Shape{{circlePiece(0.2)}});
        set(ball, Position{{0, 0.2}}, Conductor{}, MadeOf{});
        ObjectId const pool = give("pool", Shape{{boxPiece(2, 2)}});
        set(pool, Position{{6, 1}}, Liquid{});
        ObjectId const magnet = give("magnet", Shape{{boxPiece(0.2, 0.2)}});
        set(magnet, Position{{-6, 0.1}}, Electromagnet{}, MagneticStrength{5}, Conductor{});
        ObjectId const ear = give("ear", SoundSensor{});
        set(ear, Position{{-3, 1}}, Conductor{});
        ObjectId const source = give("source", ElectricalSource{});
        set(source, Conductor{});
        static_cast<void>(store);
        world.start();
        world.step();
        world.step();
    }
    template <class P>
    ObjectId give(char const* name, P value) {
        ObjectId const id = world.store().create(name);
        world.store().column<P>().set(id, std::move(value));
        return id;
    }
    template <class... P>
    void set(ObjectId id, P... values) {
        (world.store().column<P>().set(id, std::move(values)), ...);
    }
};

template <class... P>
struct List {};
// Each new slot must be added to this list; its type declares how it is covered.
using AllSlots =
    List<Hand, SecondHand, PlayerCommands, PopulationChanges, Contacts, ContactPatches, Impacts, JointForces,
         OverloadedJoints, MotionCauses, SolverChoice, LinearGravityVector, BuoyancyForce, CentreOfBuoyancy,
         Immersions, GraphChanges, MagnetSwitching, Sounds, FrameParts, ForceRates, ForceLag, EngineState>;

template <class P>
void checkSlot(World& world) {
    SCOPED_TRACE(P::text.name);
    ASSERT_NE(world.find<P>(), nullptr) << "nothing in the scene activates its provider";
    P& value = world.store().slot<P>().value();
    P const before = value;
    std::set<std::uint64_t> seen{world.stateHash()};
    int changed = 0;
    for (int number = 0;; ++number) {
        int left = number;
        bool const done = changeLeaf(value, left);
        // To reach a leaf, an element may have been added to a list, which changes the hash as well.
        if (done && P::coverage.kind == Coverage::Kind::hashed) {
            EXPECT_TRUE(seen.insert(world.stateHash()).second) << "member " << number;
        } else if (done) {
            EXPECT_TRUE(seen.contains(world.stateHash()))
                << "member " << number << " is declared as left out";
        }
        value = before;
        if (!done) {
            break;
        }
        ++changed;
    }
    EXPECT_GT(changed + (P::coverage.kind == Coverage::Kind::leftOut ? 1 : 0), 0);
}
template <class... P>
void checkSlots(World& world, List<P...> const&) {
    (checkSlot<P>(world), ...);
}
template <class... P>
std::set<PropertyInfo const*> infosOf(List<P...> const&) {
    return {&propertyInfo<P>()...};
}

TEST(StateHashCovers, EveryMemberOfEverySlotExceptThoseListedWithAReason) {
    std::set<PropertyInfo const*> offered;
    for (Registration const& component : gameData().registry.components()) {
        if (component.info->kind == ComponentKind::resolver) {
            offered.insert(component.info->offers.begin(), component.info->offers.end());
        }
    }
    EXPECT_EQ(offered, infosOf(AllSlots{})) << "a slot is missing in the list of this test";
    for (PropertyInfo const* info : offered) {
        EXPECT_EQ(info->coverage.kind == Coverage::Kind::hashed, info->coverage.reason.empty())
            << info->text.name << " is left out without a reason";
    }
    Everything all;
    checkSlots(all.world, AllSlots{});
}

// A value that is recomputed in each turn is state if its provider has a period: it is kept for several
// frames.
TEST(StateHashCovers, ValuesThatAreKeptForSeveralFrames) {
    for (int const period : {1, 5}) {
        Everything all({.threads = 1, .detail = {}, .periods = {{"Buoyancy", period}}});
        std::uint64_t const before = all.world.stateHash();
        all.world.store().slot<BuoyancyForce>().value().forces.emplace_back();
        EXPECT_EQ(all.world.stateHash() == before, period == 1);
    }
}

template <ResolverRole Role, class C>
void checkCall() {
    SCOPED_TRACE(C::text.name);
    auto const hashOf = [](C const* call, EventId cause) {
        CallSource<Role> source;
        if (call != nullptr) {
            auto& buffer = std::get<CallBuffer<C>>(source.chunks.front());
            buffer.push(*call);
            buffer.setCauseOfLast(cause);
        }
        StateHash hash;
        source.hash(hash);
        return hash.digest();
    };
    std::set<std::uint64_t> seen{hashOf(nullptr, {})};
    C const plain{};
    EXPECT_TRUE(seen.insert(hashOf(&plain, {})).second) << "with and without a call";
    EXPECT_EQ(hashOf(&plain, {5}), hashOf(&plain, {})) << "tracing must not influence the hash";
    int changed = 0;
    for (;; ++changed) {
        C call{};
        int left = changed;
        if (!changeLeaf(call, left)) {
            break;
        }
        EXPECT_TRUE(seen.insert(hashOf(&call, {})).second) << "member " << changed;
    }
    EXPECT_GT(changed, 0);
}
template <class Role, class... C>
void checkCalls(CallList<C...> const&) {
    (checkCall<Role, C>(), ...);
}
template <class... Role>
void checkRoles() {
    std::set<std::string_view> tested{std::string_view(Role::name)...};
    std::set<std::string_view> registered;
    for (Registration const& component : gameData().registry.components()) {
        if (component.info->kind == ComponentKind::resolver && !component.info->calls.empty()) {
            registered.insert(component.info->roleName);
        }
    }
    EXPECT_EQ(tested, registered);
    (checkCalls<Role>(typename Role::Calls{}), ...);
}

TEST(StateHashCovers, EveryMemberOfEveryHeldOrWaitingCall) {
    checkRoles<PopulationRole, PlayerRole, FrameRole, DynamicsRole, ElectricityRole, MagneticsRole,
               BuoyancyRole, SoundRole>();
}

// ---- States that hashes did not distinguish in the past.

PlayerInput input(PlayerInput::Kind kind, ObjectId object, Vec2 at) {
    return {.kind = kind, .object = object, .other = {}, .at = at};
}

TEST(StateHashDistinguishes, AHandThatHoldsFromOneThatDoesNot) {
    Everything holding;
    Everything free;
    ASSERT_EQ(holding.world.stateHash(), free.world.stateHash());
    ObjectId const ball = holding.world.store().find("ball");
    holding.world.feed(input(PlayerInput::Kind::grab, ball, {0, 0.2}));
    EXPECT_NE(holding.world.stateHash(), free.world.stateHash())
        << "calls that wait for the next frame are covered";
    holding.world.step();
    free.world.step();
    EXPECT_NE(holding.world.stateHash(), free.world.stateHash());
}

TEST(StateHashDistinguishes, WorldsThatRingFromSilentOnes) {
    Everything silent;
    Everything ringing;
    Sounds::Body bell;
    bell.object = ringing.world.store().find("ball");
    bell.rings = {{440, 1, 1, 1}};
    ringing.world.store().slot<Sounds>().value().bodies.push_back(bell);
    EXPECT_NE(ringing.world.stateHash(), silent.world.stateHash());
}

TEST(StateHashDistinguishes, DetailAndPeriods) {
    std::set<std::uint64_t> seen;
    seen.insert(Everything().world.stateHash());
    EXPECT_TRUE(seen.insert(Everything({.threads = 1, .detail = {{"electricity", "nodal"}}, .periods = {}})
                                .world.stateHash())
                    .second);
    EXPECT_TRUE(
        seen.insert(
                Everything({.threads = 1, .detail = {}, .periods = {{"Liquid Drag", 2}}}).world.stateHash())
            .second);
    // Two frames in, but another turn of a component with a period is due.
    Everything third({.threads = 1, .detail = {}, .periods = {{"Liquid Drag", 2}}});
    EXPECT_FALSE(seen.insert(third.world.stateHash()).second);
}

TEST(StateHashDistinguishes, TheNextIdsOfObjects) {
    World plain(gameData().registry);
    World used(gameData().registry);
    used.store().destroy({used.store().create("gone")});
    EXPECT_NE(plain.stateHash(), used.stateHash()) << "the next object has another id";
}

TEST(StateHashDoesNotShow, TracingAndTheNumberOfThreads) {
    std::uint64_t const plain = Everything().world.stateHash();
    EXPECT_EQ(Everything({.threads = 1, .detail = {}, .periods = {}, .trace = true}).world.stateHash(),
              plain);
    EXPECT_EQ(Everything({.threads = 3, .detail = {}, .periods = {}, .trace = false, .rowsWorthThreads = 0})
                  .world.stateHash(),
              plain);
}

} // namespace
} // namespace trembler::determinism
