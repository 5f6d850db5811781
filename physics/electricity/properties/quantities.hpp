// Volts, amperes and watts, derived by the more expensive detail levels of electricity.
#pragma once

#include "runtime/object/object_id.hpp"
#include "runtime/property/description.hpp"
#include "runtime/trace/event.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace trembler {

/// How a circuit was analysed.
enum class ElectricalLevel : std::uint8_t { singleCable, twoWire, flow, nodal };

/// Why a circuit needs a level.
enum class ElectricalReason : std::uint8_t {
    noReturn,   ///< the world never had a return: connections are whole cables
    onOffOnly,  ///< it has returns, but no object with a resistance, an EMF, a rating or a fuse
    resistance, ///< an object has one
    emf,
    rating,
    fuse,
    asked, ///< the level was requested
};

/// The quantities of circuits beyond on and off. Empty with the levels single-cable and two-wire.
struct ElectricalQuantities {
    static constexpr PropertyKind kind = PropertyKind::derived;
    static constexpr PropertyText text{
        "Electrical quantities", "electrical_quantities",
        "Potentials, currents and powers of objects, and the faults of their circuits."};
    struct Entry {
        ObjectId object;       ///< invalid while no conductor has this index
        ObjectId circuit;      ///< the first object of its circuit, by id
        double potential = 0;  ///< V, of its middle above the return of its network
        double current = 0;    ///< A through it: half of the currents of its connections, in and out together
        double power = 0;      ///< W that become heat, or light, in it
        double supplied = 0;   ///< W that its EMF gives
        double brightness = 0; ///< power over rated power; 0 without a rating
        double overload = 0;   ///< of a fuse: current over its rating; above 1 it will melt
        EventId event;         ///< "overloaded"; none without tracing
        bool floating = false; ///< not connected to a source or a return: its potential is not determined
        template <class Self, class Visitor>
        static void describe(Self& self, Visitor&& visit) {
            visit(FieldInfo{.key = "object", .unit = "", .meaning = "the conductor"}, self.object);
            visit(FieldInfo{.key = "circuit", .unit = "", .meaning = "the first object of its circuit"},
                  self.circuit);
            visit(FieldInfo{.key = "potential",
                            .unit = "V",
                            .meaning = "of its middle, relative to the return of its network"},
                  self.potential);
            visit(FieldInfo{.key = "current", .unit = "A", .meaning = "through it"}, self.current);
            visit(FieldInfo{.key = "power", .unit = "W", .meaning = "that becomes heat or light in it"},
                  self.power);
            visit(FieldInfo{.key = "supplied", .unit = "W", .meaning = "that its EMF supplies"},
                  self.supplied);
            visit(FieldInfo{.key = "brightness", .unit = "", .meaning = "power divided by rated power"},
                  self.brightness);
            visit(FieldInfo{.key = "overload",
                            .unit = "",
                            .meaning = "of a fuse: current divided by its rating"},
                  self.overload);
            visit(FieldInfo{.key = "floating",
                            .unit = "",
                            .meaning = "whether it is connected to no source and no return"},
                  self.floating);
        }
    };
    /// One circuit: all objects connected to `first`, the first of them by id.
    struct Circuit {
        ObjectId first;
        std::uint32_t objects = 0;
        ElectricalLevel level = ElectricalLevel::twoWire;
        ElectricalReason reason = ElectricalReason::onOffOnly;
        ObjectId because;    ///< the first object that is the reason, if any
        double residual = 0; ///< nodal: the error in Kirchhoff's first law, as a share of the largest current
        bool floating = false;            ///< the whole circuit
        std::vector<ObjectId> shorted;    ///< sources, ascending
        double flow = 0;                  ///< flow: A, the greatest possible current
        std::vector<ObjectId> bottleneck; ///< flow: the objects that limit it, nearest the source; ascending
    };
    std::vector<Entry> byIndex;    ///< by object index
    std::vector<Circuit> circuits; ///< ascending by `first`
    std::uint64_t frame = 0;       ///< of the last change

    /// The entry of an object, or nullptr if it has none.
    [[nodiscard]] Entry const* find(ObjectId id) const {
        return id.index < byIndex.size() && byIndex[id.index].object == id ? &byIndex[id.index] : nullptr;
    }
    /// The circuit of an object, or nullptr.
    [[nodiscard]] Circuit const* circuitOf(ObjectId id) const {
        Entry const* const entry = find(id);
        if (entry == nullptr) {
            return nullptr;
        }
        auto const at = std::lower_bound(circuits.begin(), circuits.end(), entry->circuit,
                                         [](Circuit const& c, ObjectId first) { return c.first < first; });
        return at == circuits.end() || at->first != entry->circuit ? nullptr : &*at;
    }

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "objects", .unit = "", .meaning = "one for each conductor"}, self.byIndex);
    }
};

[[nodiscard]] std::string_view nameOf(ElectricalLevel level);
/// In words, for people: "a resistance".
[[nodiscard]] std::string_view nameOf(ElectricalReason reason);

} // namespace trembler
