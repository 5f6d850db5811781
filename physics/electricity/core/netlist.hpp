// The part of a circuit in one of its networks, as a netlist: the input of nodal analysis and of other
// programs.
#pragma once

#include "physics/electricity/core/network_members.hpp"
#include "physics/electricity/properties/ratings.hpp"
#include "runtime/property/column.hpp"

#include <vector>

namespace trembler {

/// The columns with the objects' volts, amperes and ohms; null if no object has such a property.
struct NodalColumns {
    Column<Resistance> const& resistances;
    Column<Emf> const& emfs;
    Column<RatedPower> const& ratings;
    Column<Fuse> const& fuses;
};

/// The EMF, in V, of a source that states none; the source is ideal.
inline constexpr double unstatedEmf = 12;

/// The resistance of an object, in ohm: the stated one, or the one that follows from its rating, or 0. Always
/// 0 or within leastResistance and greatestResistance, even if a program has written other values.
[[nodiscard]] double resistanceOf(NodalColumns const& columns, ObjectId object);

/// Nodes are the middles of the objects that take part in the network, in order of their ids, and after them
/// the return node, at 0 V. A branch is a connection between two objects, or of a terminal with the return
/// node; the branch of a source contains its EMF. A branch holds half the resistance of each object at its
/// ends.
struct Netlist {
    enum class Kind : std::uint8_t { connection, source, returning };
    struct Branch {
        std::uint32_t from = 0; ///< of a source: the return node
        std::uint32_t to = 0;   ///< of a return: the return node
        Kind kind = Kind::connection;
        double resistance = 0; ///< ohm; 0: ideal
        double emf = 0;        ///< V, raises the potential from `from` to `to`
        friend bool operator==(Branch const&, Branch const&) = default;
    };
    std::vector<ObjectId> objects;     ///< by node, ascending
    std::vector<double> resistances;   ///< ohm, by node, of the whole object
    std::vector<std::uint32_t> vertex; ///< by node: in the circuit
    std::vector<Branch> branches;      ///< connections, then sources, then returns; each in order of objects

    [[nodiscard]] std::uint32_t earth() const { return static_cast<std::uint32_t>(objects.size()); }
};

/// The netlist of one network in a circuit. It does not depend on the order in which the circuit was walked.
/// For circuits of many networks `members` are those of the circuit: then only the network's own vertices and
/// the plain conductors are visited, instead of all vertices. The netlist is the same.
void makeNetlist(Circuit const& circuit, NodalColumns const& columns, std::string_view network,
                 Netlist& netlist, NetworkMembers const* members = nullptr);

} // namespace trembler
