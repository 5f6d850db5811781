// One connected component of the electricity graph, packed for analysis, and the walk that finds it.
#pragma once

#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/graph.hpp"

#include <cstdint>
#include <string_view>
#include <vector>

namespace trembler {

/// The columns that all detail levels of electricity read.
struct ElectricityColumns {
    Column<ElectricityGraph> const& graph;
    Column<Conductor> const& conductors;
    Column<ElectricalSource> const& sources;
    Column<ElectricalReturn> const& returns;
};

/// Vertices are numbered from 0 in the order in which the walk met them; no result may depend on that order.
struct Circuit {
    /// An object that is joined to the source node, or to the return node, of a network.
    struct Terminal {
        std::string_view network;
        std::uint32_t vertex;
        friend auto operator<=>(Terminal const&, Terminal const&) = default;
    };
    std::vector<ObjectId> objects;          ///< by vertex
    std::vector<std::uint32_t> offsets;     ///< by vertex, one more at the end: where its neighbours begin
    std::vector<std::uint32_t> neighbours;  ///< every connection is in it twice
    std::vector<std::string_view> networks; ///< by vertex: its only network; empty: any network
    std::vector<Terminal> sources;          ///< ascending
    std::vector<Terminal> returns;          ///< ascending

    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(objects.size()); }
    [[nodiscard]] std::span<std::uint32_t const> neighboursOf(std::uint32_t vertex) const {
        return std::span(neighbours).subspan(offsets[vertex], offsets[vertex + 1] - offsets[vertex]);
    }
    /// Plain conductors take part in every network, others in their own (A.6.2).
    [[nodiscard]] bool takesPart(std::uint32_t vertex, std::string_view network) const {
        return networks[vertex].empty() || networks[vertex] == network;
    }
    /// The networks that have a source or a return in this circuit, ascending.
    [[nodiscard]] std::vector<std::string_view> terminalNetworks() const;
};

/// Walks from objects to all objects connected to them, each circuit once. Breadth first and without
/// recursion, so that a chain of a million objects is possible. Reuses its memory between walks.
class CircuitWalk {
public:
    static constexpr std::uint32_t none = 0xffffffffU;

    /// Marks all objects as not visited.
    void begin(ElectricityColumns const& columns);
    /// Packs the circuit of `seed`. Returns false if the circuit was visited since begin(), or the object is
    /// no vertex.
    bool walk(ElectricityColumns const& columns, ObjectId seed, Circuit& circuit);
    /// The circuit in which an object was visited since begin(), counted from 0 in order of walks, or `none`.
    [[nodiscard]] std::uint32_t circuitOf(ObjectId id) const {
        return id.index < places_.size() && places_[id.index].circuit >= base_
                   ? static_cast<std::uint32_t>(places_[id.index].circuit - base_)
                   : none;
    }

private:
    struct Place {
        std::uint64_t circuit = 0; // counted over all walks since construction, so begin() need not clear
        std::uint32_t vertex = 0;
    };
    std::uint32_t enter(ElectricityColumns const& columns, ObjectId id, Circuit& circuit);

    std::vector<Place> places_; // by object index
    std::uint64_t base_ = 1;
    std::uint64_t next_ = 1;
};

} // namespace trembler
