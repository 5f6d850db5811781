// Descriptions as numbers: readers, providers, callers and alternatives.
#include "runtime/world/registry.hpp"
#include "tests/runtime/world/descriptions.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

using namespace descriptions;

TEST(ComponentGraph, ListsReadersProvidersAndCallers) {
    Descriptions d;
    std::size_t const glue =
        d.interaction({.name = "glue", .needs = {"o2", "o1"}, .reads = {"p", "o3"}, .role = 1});
    std::size_t const one = d.resolver({.name = "one", .needsAny = {"o1"}, .offers = {"p"}, .role = 1});
    std::size_t const two = d.resolver({.name = "two", .offers = {"p"}, .role = 1});
    std::size_t const set = d.dps({.name = "set", .reads = {"p"}, .offers = {"q"}});
    std::size_t const lost = d.interaction({.name = "lost", .reads = {"nobody's"}, .role = 2});
    ComponentGraph const graph(d.list());
    using Numbers = ComponentGraph::Numbers;

    ASSERT_EQ(graph.objectProperties, (std::vector{d.property("o1"), d.property("o2")}))
        << "o3 is read, but does not activate the component";
    EXPECT_EQ(graph.components[glue].neededAll, (Numbers{1, 0}));
    EXPECT_EQ(graph.components[one].neededAny, (Numbers{0}));

    ASSERT_EQ(graph.offered.size(), 3U); // by key: a property without provider, p, q
    EXPECT_EQ(graph.offered[0].info, d.property("nobody's"));
    EXPECT_EQ(graph.offered[0].readers, (Numbers{lost}));
    EXPECT_EQ(graph.offered[0].providers, (Numbers{}));
    EXPECT_EQ(graph.offered[1].readers, (Numbers{glue, set}));
    EXPECT_EQ(graph.offered[1].providers, (Numbers{one, two}));
    EXPECT_EQ(graph.offered[2].providers, (Numbers{set}));
    EXPECT_EQ(graph.components[glue].reads, (Numbers{1})) << "object properties are not included";

    EXPECT_EQ(graph.components[one].group, graph.components[two].group);
    EXPECT_EQ(graph.components[glue].resolvers, graph.components[one].group);
    EXPECT_EQ(graph.components[lost].resolvers, std::nullopt);
    EXPECT_EQ(graph.groups[graph.components[one].group].members, (Numbers{one, two}));
    EXPECT_EQ(graph.groups[graph.components[one].group].callers, (Numbers{glue}));
}

TEST(ComponentGraph, GroupsAreTheRegistrysAlternatives) {
    Descriptions d;
    d.resolver({.name = "a", .offers = {"p"}, .role = 1});
    d.resolver({.name = "b", .offers = {"p"}, .role = 1});
    d.resolver({.name = "c", .role = 2});
    d.dps({.name = "d", .offers = {"q", "r"}});
    d.dps({.name = "e", .offers = {"r", "q"}});
    d.dps({.name = "f", .offers = {"s"}});
    d.dps({.name = "g"});
    d.dps({.name = "h"});
    d.interaction({.name = "i", .role = 1});
    d.interaction({.name = "j", .role = 1});
    auto const infos = d.list();
    ComponentGraph const graph(infos);
    for (std::size_t i = 0; i < infos.size(); ++i) {
        for (std::size_t j = 0; j < infos.size(); ++j) {
            EXPECT_EQ(graph.components[i].group == graph.components[j].group,
                      i == j || areAlternatives(*infos[i], *infos[j]))
                << infos[i]->text.name << ", " << infos[j]->text.name;
        }
    }
}

} // namespace
} // namespace trembler
