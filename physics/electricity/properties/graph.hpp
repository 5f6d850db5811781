// G_E, the electricity graph (A.3), kept as a property of the objects that are its vertices.
#pragma once

#include "runtime/component/caller_counts.hpp"
#include "runtime/property/column.hpp"

#include <vector>

namespace trembler {

class Store;

/// An object's part of G_E: the objects that it is connected to. Every connection stands in the rows of both
/// its objects. Every conductor has a row; nothing else has.
struct ElectricityGraph {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "G_E", "electricity_graph",
        "The electricity graph: whom the object is connected to, and how often by "
        "whom: by an interaction, or by the level.",
        PropertyPlace::hidden};
    struct Connection {
        ObjectId to;
        CallerCounts counts; ///< CallerId::level(): the wires that the level has laid

        template <class Self, class Visitor>
        static void describe(Self& self, Visitor&& visit) {
            visit(FieldInfo{.key = "to", .unit = "", .meaning = "the other object"}, self.to);
            auto by = self.counts.entries();
            visit(FieldInfo{.key = "by", .unit = "", .meaning = "who connects them, and how often"}, by);
        }
    };
    std::vector<Connection> connections; ///< ascending by `to`; only present ones

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "connections", .unit = "", .meaning = "neighbours in the graph"},
              self.connections);
    }
};

/// How `a` and `b` are connected at present; all counts zero if they are not or one of them is no conductor.
/// Thread-safe while the graph does not change.
[[nodiscard]] CallerCounts connectionBetween(Store const& store, ObjectId a, ObjectId b);
[[nodiscard]] CallerCounts connectionBetween(Column<ElectricityGraph> const& graph, ObjectId a, ObjectId b);

/// Sets how two different vertices of the graph are connected, in both rows; all counts zero takes the
/// connection away.
void setConnection(Column<ElectricityGraph>& graph, ObjectId a, ObjectId b, CallerCounts const& counts);

/// Gives a row to each of `vertices` (ascending) that has none. O(their number) where they are the latest
/// objects.
void addVertices(Column<ElectricityGraph>& graph, std::span<ObjectId const> vertices);

} // namespace trembler
