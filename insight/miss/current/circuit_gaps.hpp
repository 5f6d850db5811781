// Where a circuit is open: the narrowest gaps that would have to be closed for current to flow through an
// object.
#pragma once

#include "runtime/world/world.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace trembler::insight {

/// A gap between two conductors that do not touch.
struct CircuitGap {
    ObjectId a;
    ObjectId b;
    double width = 0; ///< m
    Vec2 from{};      ///< m, in the world, on a
    Vec2 to{};        ///< m, on b
    std::string nameA{};
    std::string nameB{};
};

/// The gaps in the way of a current through an object, narrowest in sum; none: its circuit is closed.
struct CircuitCut {
    std::vector<CircuitGap> gaps;
    double width = 0; ///< m, of all gaps
    /// No gaps between conductors lead there: it has no source, or nothing is near enough.
    bool hopeless = false;
};

/// Looks at the conductors of one world. The work is done again only if something has moved and the last look
/// was `patience` frames ago, or a connection has changed. Not thread-safe.
class CircuitSight {
public:
    /// Gaps wider than this, in m, are not considered.
    static constexpr double widest = 3;
    static constexpr std::uint64_t patience = 6;

    /// Two paths over conductors that share none but the object, from it to a source and to a return of one
    /// network; in a world that never had a return, one path to a source. Connections of the electricity
    /// graph cost nothing, gaps their width: a minimum-cost flow of two units by shortest paths with vertices
    /// split (Suurballe 1974). At the level two-wire, a cut without gaps means that the object is on.
    [[nodiscard]] CircuitCut const& cutAt(World const& world, ObjectId object);

private:
    /// A pair of conductors that are near each other, by their places in conductors_.
    struct Link {
        std::size_t a = 0;
        std::size_t b = 0;
        CircuitGap gap; ///< of width 0 if they are connected
    };

    void look(World const& world);
    [[nodiscard]] CircuitCut cutIn(World const& world, std::size_t object, std::string const& network,
                                   bool onePath) const;

    bool known_ = false;
    std::uint64_t lookedIn_ = 0;  // frame
    std::uint64_t positions_ = 0; // versions of what was looked at
    std::uint64_t rotations_ = 0;
    std::uint64_t graph_ = 0;
    std::vector<ObjectId> conductors_; // ascending
    std::vector<Link> links_;
    std::map<ObjectId, CircuitCut> cuts_; // since then
};

} // namespace trembler::insight
