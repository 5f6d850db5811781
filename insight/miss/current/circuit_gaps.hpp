// Where a circuit is open: the narrowest gaps that would have to be closed for current to flow through an
// object.
#pragma once

#include "runtime/world/world.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace trembler::insight {

/// Why no current passes between two conductors.
enum class GapReason : std::uint8_t {
    apart,   ///< they do not touch
    slow,    ///< a generator turns too slowly to be connected with its source
    quiet,   ///< a sound sensor hears too little to connect them
    blown,   ///< one of them is a fuse that has blown
    foreign, ///< they are the two ends of a source of another network, which passes only its own current
    cut,     ///< the wire between them was cut
};
/// "apart" ..., as files spell it.
[[nodiscard]] std::string_view nameOf(GapReason reason);

/// A gap costs at least this, in m: a touch that conducts nothing is worse than a connection.
inline constexpr double leastGapCost = 1e-4;

/// A place where no current passes between two conductors.
struct CircuitGap {
    ObjectId a;
    ObjectId b;
    double width = 0; ///< m, of what a touch would close; else 0
    /// m: its width, or the width of a gap that would be as bad.
    double cost = 0;
    GapReason reason = GapReason::apart;
    ObjectId by{};     ///< the generator, the sensor or the fuse; of nameBy, see also Insulators
    double is = 0;     ///< speed in degrees a second, or level in dB(A) ...
    double needed = 0; ///< ... from which on it connects
    Vec2 from{};       ///< m, in the world, on a
    Vec2 to{};         ///< m, on b
    std::string nameA{};
    std::string nameB{};
    std::string nameBy{};
};

/// The gaps in the way of a current through an object, of least cost in sum; none: its circuit is closed.
struct CircuitCut {
    std::vector<CircuitGap> gaps;
    double width = 0; ///< m, of all gaps between conductors that are apart
    double cost = 0;  ///< m, of all gaps
    /// No gaps between conductors lead there: it has no source, or nothing is near enough.
    bool hopeless = false;
};

/// Looks at the conductors of one world. The work is done again only if something has moved, or sensors
/// listen, and the last look was `patience` frames ago, or a connection has changed. Not thread-safe.
class CircuitSight {
public:
    /// Gaps wider than this, in m, are not considered.
    static constexpr double widest = 3;
    static constexpr std::uint64_t patience = 6;

    /// From now on a wire of the present ones that is cut is a gap of that reason. Without this call such a
    /// wire is forgotten.
    void rememberWires(World const& world);

    /// Two paths over conductors that share none but the object, from it to a source and to a return of one
    /// network; in a world that never had a return, one path to a source. Connections of the electricity
    /// graph cost nothing, gaps their `cost`: a minimum-cost flow of two units by shortest paths with
    /// vertices split (Suurballe 1974). At the level two-wire, a cut without gaps means that the object is
    /// on.
    [[nodiscard]] CircuitCut const& cutAt(World const& world, ObjectId object);

private:
    /// A pair of conductors that are near each other, by their places in conductors_.
    struct Link {
        std::size_t a = 0;
        std::size_t b = 0;
        CircuitGap gap; ///< of cost 0 if they are connected
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
    std::map<ObjectId, CircuitCut> cuts_;           // since then
    std::set<std::pair<ObjectId, ObjectId>> wires_; // remembered; the lesser id first
};

} // namespace trembler::insight
