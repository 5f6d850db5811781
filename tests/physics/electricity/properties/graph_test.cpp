// The rows of the electricity graph, against a map from pairs to counts.
#include "physics/electricity/properties/graph.hpp"
#include "runtime/world/store.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <map>

namespace trembler {
namespace graph_test {
namespace {

TEST(ElectricityGraph, HoldsEveryConnectionInBothRowsInOrder) {
    EXPECT_TRUE(rc::check("the same as a map", [] {
        Column<ElectricityGraph> graph;
        std::vector<ObjectId> objects;
        int const count = *rc::gen::inRange(2, 8);
        for (int v = 0; v < count; ++v) {
            objects.push_back({static_cast<std::uint32_t>(v), 3});
        }
        addVertices(graph, objects);
        addVertices(graph, objects); // existing rows are kept
        std::map<std::pair<ObjectId, ObjectId>, std::int32_t> model;
        for (int step = *rc::gen::inRange(0, 40); step > 0; --step) {
            ObjectId const a = *rc::gen::elementOf(objects);
            ObjectId const b = *rc::gen::elementOf(objects);
            if (a == b) {
                continue;
            }
            int const count2 = *rc::gen::inRange(0, 3);
            CallerCounts counts;
            counts.add(CallerId::level(), count2);
            setConnection(graph, a, b, counts);
            model[std::minmax(a, b)] = count2;
            addVertices(graph, objects); // with their content
        }
        for (ObjectId const a : objects) {
            auto const& row = graph[a].connections;
            RC_ASSERT(std::is_sorted(row.begin(), row.end(),
                                     [](auto const& x, auto const& y) { return x.to < y.to; }));
            std::size_t present = 0;
            for (ObjectId const b : objects) {
                auto const at = model.find(std::minmax(a, b));
                std::int32_t const expected = a == b || at == model.end() ? 0 : at->second;
                RC_ASSERT(connectionBetween(graph, a, b).of(CallerId::level()) == expected);
                present += expected > 0 ? 1U : 0U;
            }
            RC_ASSERT(row.size() == present); // only existing connections
        }
    }));
}

TEST(ElectricityGraph, NonConductorsHaveNoConnections) {
    Store store;
    ObjectId const a = store.create("a");
    ObjectId const b = store.create("b");
    EXPECT_FALSE(connectionBetween(store, a, b).any()) << "there is no graph";
    auto& graph = store.column<ElectricityGraph>();
    std::array<ObjectId, 1> const first{a};
    addVertices(graph, first);
    EXPECT_FALSE(connectionBetween(store, a, b).any());
    EXPECT_FALSE(connectionBetween(store, b, a).any());
    std::array<ObjectId, 1> const second{b};
    addVertices(graph, second);
    CallerCounts counts;
    counts.add(CallerId::level(), 2);
    setConnection(graph, b, a, counts);
    EXPECT_EQ(connectionBetween(store, a, b).of(CallerId::level()), 2);
    EXPECT_EQ(connectionBetween(store, a, b), connectionBetween(store, b, a));
    store.destroy({b});
    EXPECT_FALSE(connectionBetween(store, b, a).any());
}

} // namespace
} // namespace graph_test
} // namespace trembler
