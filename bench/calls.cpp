// The cost of calls of interaction functions (5.4): a million calls recorded through the interaction's own
// interface in a running world, tracing off, and drained by a resolver, on one thread and on two. The
// reference is the least possible cost of recording: the same call appended to a plain buffer per chunk, in
// the same frames of the same run, so that the machine and its other load affect both equally. Limit: 2 times
// the reference.
//
// Measures processor time of the threads, chunk by chunk. The cost of the loop and of the clock is measured
// by another interaction that does the same without the call, and is subtracted from both.
//
// And the cost of interactions that sleep while their resolver, Dynamics, has calls to carry out in every
// frame: of 128 of them that have no calls, and of 128 that hold one each.
#include "physics/dynamics/calls.hpp"

#include "bench/measure.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/dynamics/register.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/component/resolver.hpp"
#include "runtime/population/population_resolver.hpp"
#include "runtime/property/for_each.hpp"
#include "runtime/world/world.hpp"

#include <array>
#include <atomic>
#include <cstdlib>
#include <ctime>
#include <utility>

namespace {

using namespace trembler;

constexpr std::size_t count = 1000000;
constexpr int frames = 61;
constexpr double limit = 2; // times the cost of a plain buffer

/// Processor time of this thread, ns.
std::int64_t processorTime() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return std::int64_t{1000000000} * now.tv_sec + now.tv_nsec;
}

struct Weight {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Weight", "weight", "What the object is pulled by."};
    Vec2 value;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value", .unit = "N", .meaning = "weight"}, self.value);
    }
};

// As large as a call of Dynamics's addForce.
struct Pull {
    static constexpr CallText text{"pull", "(object, force)", "Pulls the object."};
    static constexpr Algebra algebra = Algebra::sumOfRates;
    ObjectId object;
    Vec2 force;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "the object", .required = true}, self.object);
        visit(FieldInfo{.key = "force", .unit = "N", .meaning = "force", .required = true}, self.force);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
};
struct Push {
    static constexpr CallText text{"push", "(object, impulse)", "Pushes the object once."};
    static constexpr Algebra algebra = Algebra::sumOfAmounts;
    ObjectId object;
    Vec2 impulse;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "the object", .required = true}, self.object);
        visit(FieldInfo{.key = "impulse", .unit = "N s", .meaning = "impulse", .required = true},
              self.impulse);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
};
struct PullRole {
    static constexpr std::string_view name = "Pull";
    using Calls = CallList<Pull, Push>;
};

struct Drain final : Resolver<Drain, PullRole, Reads<>, Writes<>> {
    static constexpr ComponentText text{
        .name = "Drain", .effect = "bench", .level = "", .work = "Adds the calls up."};
    using Activation = NeedsAll<>;
    static inline std::int64_t took = 0;
    static inline Vec2 sum;
    [[nodiscard]] bool restless() const { return true; }
    void advance(Access& access) {
        std::int64_t const begin = processorTime();
        Vec2 total;
        access.forCalls<Pull>([&](Pull const& call, CallOrigin) { total += call.force; });
        access.forCalls<Push>([&](Push const& call, CallOrigin) { total += call.impulse; });
        took = processorTime() - begin;
        sum = total;
    }
};

// A separate buffer for every producer, which keeps its memory between frames.
constexpr std::size_t leastChunk = 256;
std::vector<std::vector<Pull>> plainBuffers(count / leastChunk + 1);

enum class Does { nothing, fills, pulls, pushes };

template <Does does>
struct Caller final : Interaction<Caller<does>, PullRole, Reads<Weight>> {
    static constexpr std::array<std::string_view, 4> names{"nothing", "fills", "pulls", "pushes"};
    static constexpr ComponentText text{.name = names[static_cast<std::size_t>(does)],
                                        .effect = "bench",
                                        .level = "",
                                        .work = "Calls once per object."};
    using Activation = NeedsAll<Weight>;
    using Base = Interaction<Caller<does>, PullRole, Reads<Weight>>;
    static inline std::atomic<std::int64_t> took = 0;
    void apply(typename Base::Access& access) {
        took = 0;
        auto const& weights = access.template read<Weight>();
        access.forChunks(weights.size(),
                         [&](typename Base::Caller& caller, std::size_t begin, std::size_t end) {
                             std::int64_t const before = processorTime();
                             ObjectId const* const owners = weights.owners().data();
                             Weight const* const values = weights.values().data();
                             std::vector<Pull>& plain = plainBuffers[begin / leastChunk];
                             if constexpr (does == Does::fills) {
                                 plain.clear();
                             }
                             for (std::size_t i = begin; i < end; ++i) {
                                 if constexpr (does == Does::pulls) {
                                     caller.call(Pull{owners[i], values[i].value});
                                 } else if constexpr (does == Does::pushes) {
                                     caller.call(Push{owners[i], values[i].value});
                                 } else if constexpr (does == Does::fills) {
                                     plain.push_back({owners[i], values[i].value});
                                 } else {
                                     bench::keep(owners[i]);
                                     bench::keep(values[i].value);
                                 }
                             }
                             took += processorTime() - before;
                         });
    }
};

template <Does does>
void measure(int threads, bench::Table& table, std::string const& name) {
    Registry registry;
    registry.component<Drain>();
    registry.component<Caller<Does::nothing>>();
    registry.component<Caller<Does::fills>>();
    registry.component<Caller<does>>();
    World world(registry, {.threads = threads, .detail = {}, .periods = {}});
    auto& weights = world.store().column<Weight>();
    for (std::uint32_t i = 0; i < count; ++i) {
        weights.set({i, 0}, {{1, 0}});
    }
    world.start();
    bench::Series calling;
    bench::Series looping;
    bench::Series filling;
    bench::Series draining;
    double first = 0;
    for (int frame = 0; frame < frames; ++frame) {
        weights.touch(); // so that all interactions are applied again
        world.step();
        auto const called = static_cast<double>(Caller<does>::took.load());
        auto const looped = static_cast<double>(Caller<Does::nothing>::took.load());
        if (frame == 0) {
            first = called - looped; // buffers grow only in the first frame
        } else {
            calling.add(called);
            looping.add(looped);
            filling.add(static_cast<double>(Caller<Does::fills>::took.load()));
            draining.add(static_cast<double>(Drain::took));
            if (Drain::sum.x != static_cast<double>(count)) {
                std::printf("calls were lost: %g\n", Drain::sum.x);
                std::exit(1);
            }
        }
    }
    double const perCall = (calling.median() - looping.median()) / count;
    double const plain = (filling.median() - looping.median()) / count;
    table.row(name + ": loop alone", looping.median() / count, "ns per object");
    table.row(name + ": recording, first frame", first / count, "ns per call");
    table.row(name + ": a plain buffer", plain, "ns per call");
    table.row(name + ": recording", perCall, "ns per call");
    table.row(name + ": recording", perCall / plain, "times a plain buffer", perCall / plain, limit);
    table.row(name + ": draining", draining.median() / count, "ns per call");

    // With the interactions asleep: held calls are drained again without being recorded again.
    if (does == Does::pulls) {
        bench::Series held;
        for (int frame = 0; frame < frames; ++frame) {
            world.step();
            held.add(static_cast<double>(Drain::took));
        }
        table.row(name + ": held, the caller asleep", held.median() / count, "ns per call and frame");
    }
}

// A type of interaction for each number, as interactions are distinguished by their types.
constexpr int sleepers = 128;
template <int number>
constexpr std::array<char, 10> sleeperName{'S', 'l', 'e', 'e', 'p', ' ', 'a' + number / 26, 'a' + number % 26,
                                           0};

template <int number, bool calls>
struct Sleeper final : Interaction<Sleeper<number, calls>, DynamicsRole, Reads<Weight>> {
    static constexpr ComponentText text{
        .name = sleeperName<number>.data(), .effect = "bench", .level = "", .work = "Sleeps."};
    using Activation = NeedsAll<Weight>;
    using Base = Interaction<Sleeper<number, calls>, DynamicsRole, Reads<Weight>>;
    void apply([[maybe_unused]] typename Base::Access& access) {
        if constexpr (calls) {
            forEach(
                [&](ObjectId id, Weight const&) {
                    access.call(AddForceToPoint{.object = id, .point = {}, .force = {0, 1e-3}});
                },
                access.template read<Weight>());
        }
    }
};
// Its force at a point has another torque in every frame, as the body moves, so Dynamics drains its calls in
// every frame.
struct Waker final : Interaction<Waker, DynamicsRole, Reads<Weight>> {
    static constexpr ComponentText text{
        .name = "Waker", .effect = "bench", .level = "", .work = "Holds a force at a point."};
    using Activation = NeedsAll<Weight>;
    void apply(Access& access) {
        forEach(
            [&](ObjectId id, Weight const&) {
                access.call(AddForceToPoint{.object = id, .point = {}, .force = {0, 1e-3}});
            },
            access.read<Weight>());
    }
};

template <bool calls, int... number>
void addSleepers(Registry& registry, std::integer_sequence<int, number...>) {
    (registry.component<Sleeper<number, calls>>(), ...);
}

/// ns of processor time for a frame of one body, the least of many blocks of frames.
template <bool calls>
double frameBesideSleepers(bool any) {
    Registry registry;
    registerRuntime(registry);
    registerDynamics(registry);
    registry.component<Waker>();
    if (any) {
        addSleepers<calls>(registry, std::make_integer_sequence<int, sleepers>());
    }
    World world(registry, {.threads = 1, .detail = {}, .periods = {}});
    ObjectId const body = world.store().create("body");
    world.store().column<Shape>().set(body, {{circlePiece(0.1)}});
    world.store().column<Density>().set(body, {1000});
    world.store().column<Position>().set(body, {});
    world.store().column<Velocity>().set(body, {{0.05, 0}});
    world.store().column<Weight>().set(body, {});
    world.start();
    constexpr int blockFrames = 300;
    double least = 0;
    for (int block = 0; block < 60; ++block) {
        std::int64_t const begin = processorTime();
        for (int frame = 0; frame < blockFrames; ++frame) {
            world.step();
        }
        auto const took = static_cast<double>(processorTime() - begin) / blockFrames;
        least = block == 0 ? took : std::min(least, took);
    }
    return least;
}

void measureSleepers() {
    double const alone = frameBesideSleepers<false>(false);
    bench::Table table("Interactions that sleep beside a resolver that drains calls in every frame");
    table.row("without calls", (frameBesideSleepers<false>(true) - alone) / sleepers, "ns a frame");
    table.row("holding one call", (frameBesideSleepers<true>(true) - alone) / sleepers, "ns a frame");
    table.print();
}

} // namespace

int main() {
    for (int const threads : {1, 2}) {
        bench::Table table("Interaction functions, 1,000,000 calls of 24 bytes, " + std::to_string(threads) +
                           (threads == 1 ? " thread" : " threads, processor time of both"));
        measure<Does::pulls>(threads, table, "held calls");
        measure<Does::pushes>(threads, table, "calls once");
        table.print();
    }
    measureSleepers();
    return 0;
}
