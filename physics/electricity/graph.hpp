// G_E, the electricity graph (A.3), kept as a property of the objects that are its vertices.
#pragma once

#include "physics/electricity/calls.hpp"
#include "runtime/property/column.hpp"

#include <vector>

namespace trembler {

class Store;

/// How two objects are connected: how often, for each cause. None is ever below zero.
struct ConnectionCounts {
    std::array<std::int32_t, connectionCauses> byCause{};

    [[nodiscard]] std::int32_t of(ConnectionCause cause) const {
        return byCause[static_cast<std::size_t>(cause)];
    }
    [[nodiscard]] std::int32_t& of(ConnectionCause cause) { return byCause[static_cast<std::size_t>(cause)]; }
    [[nodiscard]] bool connected() const { return *this != ConnectionCounts{}; }
    friend bool operator==(ConnectionCounts const&, ConnectionCounts const&) = default;
};

/// An object's part of G_E: whom it is connected to. Every connection stands in the rows of both its objects.
/// Every conductor has a row; nothing else has.
struct ElectricityGraph {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "G_E", "electricity_graph",
        "The electricity graph: whom the object is connected to, and how often for "
        "which cause.",
        PropertyPlace::hidden};
    struct Connection {
        ObjectId to;
        ConnectionCounts counts;

        template <class Self, class Visitor>
        static void describe(Self& self, Visitor&& visit) {
            visit(FieldInfo{.key = "to", .unit = "", .meaning = "the other object"}, self.to);
            visit(FieldInfo{.key = "wire", .unit = "", .meaning = "number of wires"},
                  self.counts.of(ConnectionCause::wire));
            visit(FieldInfo{.key = "contact", .unit = "", .meaning = "number of contacts"},
                  self.counts.of(ConnectionCause::contact));
            visit(FieldInfo{.key = "other", .unit = "", .meaning = "number of other causes"},
                  self.counts.of(ConnectionCause::other));
        }
    };
    std::vector<Connection> connections; ///< ascending by `to`; only those with a count above zero

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "connections", .unit = "", .meaning = "neighbours in the graph"},
              self.connections);
    }
};

/// How `a` and `b` are connected at present; all counts zero if they are not or one of them is no conductor.
/// Thread-safe while nobody changes the graph.
[[nodiscard]] ConnectionCounts connectionBetween(Store const& store, ObjectId a, ObjectId b);
[[nodiscard]] ConnectionCounts connectionBetween(Column<ElectricityGraph> const& graph, ObjectId a,
                                                 ObjectId b);

/// Sets how two different vertices of the graph are connected, in both rows; all counts zero takes the
/// connection away.
void setConnection(Column<ElectricityGraph>& graph, ObjectId a, ObjectId b, ConnectionCounts const& counts);

/// Gives a row to each of `vertices` (ascending) that has none. O(their number) where they are the latest
/// objects.
void addVertices(Column<ElectricityGraph>& graph, std::span<ObjectId const> vertices);

} // namespace trembler
