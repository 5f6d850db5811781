// The objects that are on, found without blocks and without incremental updates: the reference for the detail
// levels.
#pragma once

#include "tests/physics/electricity/circuit_world.hpp"

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>

namespace trembler::test {

/// An independent model of a world: conductors, their roles in networks, and counted connections.
struct Oracle {
    struct Part {
        std::string network;                  ///< of the conductor
        std::optional<std::string> source;    ///< network
        std::optional<std::string> returning; ///< network
    };
    using Pair = std::pair<ObjectId, ObjectId>; ///< first < second
    std::map<ObjectId, Part> parts;
    std::map<Pair, std::array<int, scripts>> counts;

    /// The effect of one frame's calls: net change per pair and caller, limited to at least zero.
    void carryOut(std::vector<Script::Line> const& lines);
    void destroy(ObjectId id);
    [[nodiscard]] bool connected(ObjectId a, ObjectId b) const;

    /// On by flood fill from the sources, over disjoint sets.
    [[nodiscard]] std::set<ObjectId> onBySingleCable() const;
    /// On by flow: an object is on if in some network one unit can flow from it to the source and one to the
    /// return, through no other object twice.
    [[nodiscard]] std::set<ObjectId> onByTwoWire() const;

private:
    [[nodiscard]] std::set<std::string> networks() const;
    [[nodiscard]] bool takesPart(ObjectId id, std::string const& network) const;
    [[nodiscard]] bool flowsFrom(ObjectId id, std::string const& network) const;
};

} // namespace trembler::test
