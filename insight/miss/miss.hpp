// How far a goal, or one of its conditions, was from being met.
#pragma once

#include "insight/miss/current/circuit_gaps.hpp"
#include "runtime/object/object_id.hpp"
#include "runtime/trace/event.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::insight {

/// The missing quantity, and the unit of Miss::by.
enum class Lack : std::uint8_t {
    nothing,  ///< it is met
    distance, ///< m, between two objects or to an area or a place
    gap,      ///< m, of all gaps of a circuit
    source,   ///< 1: a current has no source that gaps could connect
    power,    ///< W, until an object in a closed circuit is on
    shorted,  ///< 1: the source of a closed circuit is short-circuited; the object, and the source
    force,    ///< N, that a magnet's pull is less than a weight
    lift,     ///< N, that a liquid's lift is less than a weight
    torque,   ///< N m, by which a load turns something more than a liquid rights it
    count,    ///< of objects for which a condition must hold, or must not
    time,     ///< s, for which a condition must hold without a break
    steps,    ///< of a sequence
    ways,     ///< of a current: connections that would have to be opened at least
    touches,  ///< pairs of objects that touch and should not
    held,     ///< 1: a magnet holds an object back from where it should be
    blocked,  ///< 1: an object stands in the way of another one
    unpushed, ///< N, of a push that would close the contact of something that nothing pushes
    push,     ///< N, that something pushed is pushed too weakly for its contact to close
    grab,     ///< 1: the player took hold of an object, without which the goal is nearer
    cut,      ///< 1: the player cut the wire between two objects, without which the goal is nearer
    removal,  ///< 1: the player removed an object, without which the goal is nearer
    absent,   ///< 1: there is no object that another one should touch
    change,   ///< 1: the state is the opposite one, and there is no measure of how near it is
};
/// "distance" ..., as files spell it.
[[nodiscard]] std::string_view nameOf(Lack lack);
/// "m", "N" ...; "" for counts.
[[nodiscard]] std::string_view unitOf(Lack lack);

struct Miss;
/// `by` stood in the way of `blocked`, by their names.
[[nodiscard]] Miss missOfBlocked(std::string by, std::string blocked);

/// What a run with the gaps of a circuit closed, by wires, with a push, or without what stood in the way or
/// the player's deed, showed about the goal.
enum class IfClosed : std::uint8_t {
    unknown, ///< there was no such run, or it came no nearer
    nearer,  ///< it came nearer to the goal
    met,     ///< it met the goal
};

/// A connection through which a current flows that should not; by the names of its ends.
struct CurrentWay {
    ObjectId a;
    ObjectId b;
    std::string nameA{};
    std::string nameB{};
};

/// How far one condition is from being met at a moment.
struct Miss {
    /// 0 (met) to 1, without a dimension: the less, the nearer. Of a distance d it is d / (d + 0.5 m), and so
    /// on, so that conditions of different kinds can be compared, and added up to a condition of several.
    double measure = 1;
    Lack lack = Lack::change;
    double by = 0;                 ///< in the unit of `lack`, at least 0
    std::uint64_t frame = 0;       ///< the moment
    bool atBest = false;           ///< in `besides`: at `frame` it was least, see NearestCircuits
    std::vector<ObjectId> objects; ///< that it is about: first the one that acts or moves
    /// Their names, as the objects may no longer exist when this is read; see nameObjects().
    std::vector<std::string> names;
    Vec2 from;                             ///< m, in the world: distance, from here ...
    Vec2 to;                               ///< ... to here
    std::vector<CircuitGap> gaps;          ///< of a circuit
    IfClosed ifClosed = IfClosed::unknown; ///< of these gaps, of a block, a push or a deed
    std::vector<CurrentWay> ways;          ///< of Lack::ways: the connections
    bool tooMany = false;                  ///< of Lack::count: too many, else too few
    std::vector<Miss> besides;             ///< other obstacles, such as a magnet that was off; see Aftermath
    std::size_t child = noChild;           ///< of several conditions, the one that this is about
    static constexpr std::size_t noChild = static_cast<std::size_t>(-1);
};

/// Fills in the names of the objects and of the ends of gaps, also for the misses in `besides`.
void nameObjects(Miss& miss, Store const& store);

} // namespace trembler::insight
