// G_E, the electricity graph (A.3), kept as a property of the objects that are its vertices.
#pragma once

#include "runtime/component/caller_counts.hpp"
#include "runtime/property/column.hpp"

#include <vector>

namespace trembler {

class Store;

/// An object's part of G_E: the objects that it is connected to. Every connection is in the rows of both its
/// objects. Every conductor has a row, and no other object.
struct ElectricityGraph {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "G_E", "electricity_graph",
        "The electricity graph: the objects to which the object is connected, with the number of connections "
        "made by each interaction and by the level.",
        PropertyPlace::hidden};
    struct Connection {
        ObjectId to;
        CallerCounts counts; ///< CallerId::level() counts the wires of the level

        template <class Self, class Visitor>
        static void describe(Self& self, Visitor&& visit) {
            visit(FieldInfo{.key = "to", .unit = "", .meaning = "the other object"}, self.to);
            auto by = self.counts.entries();
            visit(FieldInfo{.key = "by",
                            .unit = "",
                            .meaning = "connections by each interaction and by the level"},
                  by);
        }
    };
    std::vector<Connection> connections; ///< ascending by `to`; only present ones

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "connections", .unit = "", .meaning = "neighbours in the graph"},
              self.connections);
    }
};

/// The counts of the connection of `a` and `b`; all zero if they are not connected or one of them is no
/// conductor. Thread-safe while the graph does not change.
[[nodiscard]] CallerCounts connectionBetween(Store const& store, ObjectId a, ObjectId b);
[[nodiscard]] CallerCounts connectionBetween(Column<ElectricityGraph> const& graph, ObjectId a, ObjectId b);

/// Sets the counts of the connection of two different vertices, in both rows; if all counts are zero, removes
/// the connection.
void setConnection(Column<ElectricityGraph>& graph, ObjectId a, ObjectId b, CallerCounts const& counts);

/// Adds a row for each of `vertices` (ascending) that has none. O(their number) if they are the latest
/// objects.
void addVertices(Column<ElectricityGraph>& graph, std::span<ObjectId const> vertices);

} // namespace trembler
