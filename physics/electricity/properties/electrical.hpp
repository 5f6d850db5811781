// The properties of objects that electricity reads, and its results.
#pragma once

#include "runtime/property/description.hpp"
#include "runtime/trace/event.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace trembler {

/// Objects without it never enter the electricity graph.
struct Conductor {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Conductor", "conductor",
                                       "True if the object can conduct electricity."};
    /// A device of one network, for example "mains", takes part in that network only (A.6.2: a battery cannot
    /// power the laser of the power plant); empty: a plain conductor, part of every network that it touches.
    std::string network;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "network",
                        .unit = "",
                        .meaning = "the only network of which it can be a part; empty: any"},
              self.network);
    }
};

/// The object is joined to the source node of a network. Sources of one network are interchangeable.
struct ElectricalSource {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Electrical source", "electrical_source",
                                       "The object is joined to the source of a network."};
    std::string network;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(
            FieldInfo{.key = "network", .unit = "", .meaning = "name of the network; empty: the common one"},
            self.network);
    }
};

/// The object is joined to the return node (earth) of a network.
struct ElectricalReturn {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Electrical return", "electrical_return",
                                       "The object is joined to the return (earth) of a network."};
    std::string network;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(
            FieldInfo{.key = "network", .unit = "", .meaning = "name of the network; empty: the common one"},
            self.network);
    }
};

/// Marks a user of electricity for display; for the graph it is an ordinary conductor.
struct ElectricalDevice {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "Electrical device", "electrical_device",
        "The object has a function while it is on, as a lamp has. For display only."};
};

/// Which objects are on. Derived by the present detail level of electricity.
struct ElectricalState {
    static constexpr PropertyKind kind = PropertyKind::derived;
    static constexpr PropertyText text{"Electrical state", "electrical_state",
                                       "Whether an object is part of a working circuit: on or off."};
    struct Entry {
        ObjectId object; ///< invalid while no conductor has this index
        bool on = false;
        EventId event; ///< recorded when it last changed; none without tracing
        template <class Self, class Visitor>
        static void describe(Self& self, Visitor&& visit) {
            visit(FieldInfo{.key = "object", .unit = "", .meaning = "the conductor"}, self.object);
            visit(FieldInfo{.key = "on", .unit = "", .meaning = "whether it is part of a working circuit"},
                  self.on);
        }
    };
    std::vector<Entry> byIndex;       ///< by object index
    std::vector<ObjectId> switchedOn; ///< in the last change, ascending
    std::vector<ObjectId>
        switchedOff;         ///< in the last change, ascending; destroyed objects are in neither list
    std::uint64_t frame = 0; ///< of the last change: the two lists are new in that frame only

    [[nodiscard]] bool isOn(ObjectId id) const {
        return id.index < byIndex.size() && byIndex[id.index].object == id && byIndex[id.index].on;
    }
    [[nodiscard]] EventId eventOf(ObjectId id) const {
        return id.index < byIndex.size() && byIndex[id.index].object == id ? byIndex[id.index].event
                                                                           : EventId{};
    }

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "objects", .unit = "", .meaning = "one for each conductor"}, self.byIndex);
    }
};

} // namespace trembler
