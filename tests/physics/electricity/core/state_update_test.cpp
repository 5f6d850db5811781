// The circuits that are analysed again; the results are the same as after analysing all of them.
#include "physics/electricity/core/state_update.hpp"
#include "tests/physics/electricity/wired_objects.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <set>

namespace trembler::test {
namespace state_update_test {
namespace {

/// Objects with a journal of their changes; all objects of a circuit are on while it has a source.
class Bench {
public:
    WiredObjects objects;
    GraphChanges changes;
    ElectricalState state;
    StateUpdate update;
    int looks = 0; ///< circuits that were analysed in the last run

    void touch(ObjectId id, EventId event = {}) {
        changes.journal.push_back({id, event, changes.number + 1});
    }
    void endOfTurn() { ++changes.number; }
    void run(StateUpdate& by, ElectricalState& into, std::vector<ObjectId> const& touchedToo = {}) {
        looks = 0;
        by.run(
            objects.columns(), changes, into,
            [&](Circuit const& circuit, std::vector<std::uint8_t>& on) {
                ++looks;
                EXPECT_TRUE(std::all_of(on.begin(), on.end(), [](std::uint8_t is) { return is == 0; }));
                std::fill(on.begin(), on.end(), circuit.sources.empty() ? std::uint8_t{0} : std::uint8_t{1});
            },
            touchedToo);
        if (by.anything()) {
            by.writeTo(into, ++frame_,
                       [](std::string_view, std::span<ObjectId const>, std::span<EventId const>) {
                           return EventId{};
                       });
        }
    }
    void run() { run(update, state); }

private:
    std::uint64_t frame_ = 0;
};

TEST(StateUpdate, AnalysesOnlyChangedCircuits) {
    Bench bench;
    for (std::uint32_t v = 0; v < 6; ++v) {
        bench.objects.conductor(v);
    }
    bench.objects.connect({0, 0}, {1, 0});
    bench.objects.connect({2, 0}, {3, 0});
    bench.objects.sources.set({0, 0}, {});
    bench.run();
    EXPECT_TRUE(bench.update.sawAll());
    EXPECT_EQ(bench.looks, 4) << "two pairs and two single objects";
    EXPECT_EQ(bench.update.circuits(), 4U);
    EXPECT_EQ(bench.state.switchedOn, (std::vector<ObjectId>{{0, 0}, {1, 0}}));
    EXPECT_EQ(bench.state.frame, 1U);
    bench.run();
    EXPECT_EQ(bench.looks, 0) << "nothing has changed";
    EXPECT_FALSE(bench.update.anything());
    bench.objects.connect({1, 0}, {2, 0});
    bench.touch({1, 0});
    bench.touch({2, 0});
    bench.endOfTurn();
    bench.run();
    EXPECT_EQ(bench.looks, 1) << "both ends belong to one circuit";
    EXPECT_FALSE(bench.update.sawAll());
    EXPECT_EQ(bench.state.switchedOn, (std::vector<ObjectId>{{2, 0}, {3, 0}}));
    EXPECT_TRUE(bench.state.switchedOff.empty());
    // A change outside of the graph, such as a resistance.
    bench.run(bench.update, bench.state, {{5, 0}});
    EXPECT_EQ(bench.looks, 1);
    EXPECT_FALSE(bench.update.anything());
}

TEST(StateUpdate, AReaderThatMissedEntriesAnalysesAllCircuits) {
    Bench bench;
    for (std::uint32_t v = 0; v < 3; ++v) {
        bench.objects.conductor(v);
    }
    bench.run();
    bench.changes.number = 9;
    bench.changes.forgotten = 8; // the changes up to the eighth are in no journal
    bench.objects.sources.set({2, 0}, {});
    bench.run();
    EXPECT_TRUE(bench.update.sawAll());
    EXPECT_EQ(bench.state.switchedOn, (std::vector<ObjectId>{{2, 0}}));
}

TEST(StateUpdate, CausesAreThoseOfTheCircuit) {
    Bench bench;
    for (std::uint32_t v = 0; v < 4; ++v) {
        bench.objects.conductor(v);
    }
    bench.objects.sources.set({0, 0}, {});
    bench.run();
    bench.objects.connect({0, 0}, {1, 0});
    EventId const event{7};
    bench.touch({3, 0}, EventId{5}); // in another circuit
    bench.touch({0, 0}, event);
    bench.touch({1, 0}, event);
    bench.endOfTurn();
    bench.run();
    ASSERT_EQ(bench.update.entries().size(), 1U);
    StateUpdate::Entry const& entry = bench.update.entries()[0];
    EXPECT_EQ(entry.object, (ObjectId{1, 0}));
    EXPECT_TRUE(entry.on && entry.switched);
    auto const causes = bench.update.causes(entry.circuit);
    ASSERT_EQ(causes.size(), 2U);
    EXPECT_EQ(causes[0], event);
    EXPECT_TRUE(bench.update.causes(99).empty());
}

// Connections are added and removed, objects are destroyed, and others are created with their indices.
TEST(StateUpdate, AgreesWithAnalysingAllCircuits) {
    EXPECT_TRUE(rc::check("an update that knows nothing finds the same state", [] {
        auto const below = [](std::uint32_t bound) {
            return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0U, bound));
        };
        Bench bench;
        std::vector<ObjectId> alive;
        for (std::uint32_t v = 0; v < 7; ++v) {
            alive.push_back(bench.objects.conductor(v));
            if (below(4) == 0) {
                bench.objects.sources.set(alive.back(), {});
            }
        }
        bench.run();
        for (int turn = 0; turn < 12; ++turn) {
            for (std::uint32_t i = 1 + below(3); i > 0; --i) {
                std::size_t const which = below(7);
                ObjectId const a = alive[which];
                ObjectId const b = alive[below(7)];
                if (below(6) == 0) {
                    for (ObjectId const other : alive) {
                        if (other != a && connectionBetween(bench.objects.graph, a, other).any()) {
                            setConnection(bench.objects.graph, a, other, {});
                            bench.touch(other);
                        }
                    }
                    bench.objects.graph.remove(a);
                    bench.objects.conductors.remove(a);
                    bench.objects.sources.remove(a);
                    bench.touch(a);
                    alive[which] = bench.objects.conductor(ObjectId{a.index, a.generation + 1});
                    bench.touch(alive[which]);
                } else if (a != b) {
                    if (connectionBetween(bench.objects.graph, a, b).any()) {
                        setConnection(bench.objects.graph, a, b, {});
                    } else {
                        bench.objects.connect(a, b);
                    }
                    bench.touch(a);
                    bench.touch(b);
                }
            }
            bench.endOfTurn();
            if (below(3) == 0) {
                continue; // a turn may be skipped
            }
            bench.run();
            StateUpdate fresh;
            ElectricalState all;
            bench.run(fresh, all);
            RC_ASSERT(bench.state.byIndex.size() == all.byIndex.size());
            for (std::size_t i = 0; i < all.byIndex.size(); ++i) {
                RC_ASSERT(bench.state.byIndex[i].object == all.byIndex[i].object);
                RC_ASSERT(bench.state.byIndex[i].on == all.byIndex[i].on);
            }
        }
    }));
}

} // namespace
} // namespace state_update_test
} // namespace trembler::test
