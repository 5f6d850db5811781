// The properties of objects that magnetism reads, and its results.
#pragma once

#include "runtime/property/coverage.hpp"
#include "runtime/property/description.hpp"
#include "runtime/property/state_hash.hpp"
#include "runtime/trace/event.hpp"

#include <array>
#include <vector>

namespace trembler {

/// Length, in m, that softens every magnetic force: F ~ r / (r² + s²)^(3/2), finite (and zero) at distance
/// zero and within 1 % of the inverse square from 0.61 m on. About the size of the parts that touch.
inline constexpr double magneticSoftening = 0.05;
/// How long the magnetisation of soft iron lags behind a magnet's field, in s: hysteresis and eddy currents
/// keep it from following at once while the iron turns, which takes energy. A body of mass m that the magnet
/// alone would swing with ω_M = √(k/m) loses its spin at the rate of magneticLag ω_M², so a steel ball that
/// rolls under a magnet rests after seconds.
inline constexpr double magneticLag = 0.02;

struct MagneticStrength {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "Magnetic strength", "magnetic_strength",
        "The magnetic strength of the object and its susceptibility to magnetic "
        "forces."};
    double strength = 0;
    double susceptibility = 0;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "strength",
                        .unit = "A m",
                        .meaning = "pole strength of each of its poles, as a magnet",
                        .minimum = 0,
                        .maximum = 1e8},
              self.strength);
        visit(FieldInfo{.key = "susceptibility",
                        .unit = "A m",
                        .meaning = "pole strength with which the poles of magnets attract it",
                        .minimum = 0,
                        .maximum = 1e8},
              self.susceptibility);
    }
};

enum class PoleSet : int { none, north, south, both };
template <>
inline constexpr std::array<std::string_view, 4> choiceNames<PoleSet>{"none", "north", "south", "both"};

/// Zero poles: an object that magnets can move. One: a monopole, cheaper. Two: a conventional magnet.
struct MagneticPoles {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Magnetic poles", "magnetic_poles",
                                       "The location of the magnetic poles."};
    PoleSet poles = PoleSet::none;
    Vec2 north;
    Vec2 south;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "poles", .unit = "", .meaning = "which poles it has", .required = true},
              self.poles);
        visit(FieldInfo{.key = "north",
                        .unit = "m",
                        .meaning = "position of the north pole, in the object's frame",
                        .minimum = -1e3,
                        .maximum = 1e3,
                        .geometry = FieldGeometry::ownVector},
              self.north);
        visit(FieldInfo{.key = "south",
                        .unit = "m",
                        .meaning = "position of the south pole, in the object's frame",
                        .minimum = -1e3,
                        .maximum = 1e3,
                        .geometry = FieldGeometry::ownVector},
              self.south);
    }
};

struct Magnet {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "Magnet on/off", "magnet",
        "If it is off, the magnet exerts no force. An electromagnet that is switched "
        "off cools down over a few frames."};
    bool on = true;
    double level = 1;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "on", .unit = "", .meaning = "whether it is switched on"}, self.on);
        visit(FieldInfo{.key = "level",
                        .unit = "",
                        .meaning = "share of its strength that acts",
                        .minimum = 0,
                        .maximum = 1},
              self.level);
    }
};

struct Electromagnet {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Is an electromagnet", "electromagnet",
                                       "The object is a magnet while it has electricity."};
    std::int32_t coolDown = 4;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "cool_down",
                        .unit = "frames",
                        .meaning = "time from switching off until its force is zero",
                        .minimum = 1,
                        .maximum = 600},
              self.coolDown);
    }
};

/// How exactly a world's magnetic forces are computed, at the detail levels that are not exact.
struct MagnetismSettings {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Magnetism settings", "magnetism",
                                       "How exactly magnetic forces are computed.", PropertyPlace::world};
    /// The limits within which the grid's two settings affect accuracy only; beyond them, relevant forces are
    /// missing.
    static constexpr double leastCutoff = 1;          ///< m
    static constexpr double greatestThreshold = 0.01; ///< N
    double cutoff = 0;
    double forceThreshold = greatestThreshold;
    double openingAngle = 0.25;
    bool lookAhead = true;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "cutoff",
                        .unit = "m",
                        .meaning = "at the detail level \"grid\": poles farther apart do not act on each "
                                   "other; 0: chosen by the force threshold",
                        .minimum = 0,
                        .maximum = 1e6,
                        .accuracy = {leastCutoff, 1e6, true}},
              self.cutoff);
        visit(FieldInfo{.key = "force_threshold",
                        .unit = "N",
                        .meaning = "at the detail level \"grid\": no pair of poles with a force of at least "
                                   "this is weakened or left out",
                        .minimum = 1e-9,
                        .maximum = 1e6,
                        .accuracy = {1e-9, greatestThreshold}},
              self.forceThreshold);
        visit(FieldInfo{.key = "opening_angle",
                        .unit = "",
                        .meaning = "at the detail level \"tree\": a cluster acts as a whole if its radius "
                                   "divided by its distance is below this; 0: never",
                        .minimum = 0,
                        .maximum = 1,
                        .accuracy = {0, 1}},
              self.openingAngle);
        visit(FieldInfo{.key = "look_ahead",
                        .unit = "",
                        .meaning = "whether forces are computed for the positions half a frame later, which "
                                   "is when they act on average"},
              self.lookAhead);
    }
    friend bool operator==(MagnetismSettings const&, MagnetismSettings const&) = default;
};

/// When each magnet was last switched, for the trace.
struct MagnetSwitching {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Magnet switching", "magnet_switching",
                                       "The event that last switched each magnet."};
    static constexpr Coverage coverage = leftOut("events of the trace have no effect");
    static constexpr std::string_view standing = "the event that last switched each magnet";
    std::vector<EventId> byIndex; ///< by object index
};

/// F_M. Forces at poles, or at the centre of an object without poles; ascending by object.
struct MagneticForce {
    static constexpr PropertyKind kind = PropertyKind::derived;
    static constexpr PropertyText text{"F_M", "magnetic_force", "The magnetic forces on each object."};
    struct Entry {
        ObjectId object;
        Vec2 point;    ///< m, in the world
        Vec2 force;    ///< N
        EventId cause; ///< event of the strongest of the actions on the object; none without tracing
        template <class Self, class Visitor>
        static void describe(Self& self, Visitor&& visit) {
            visit(FieldInfo{.key = "object", .unit = "", .meaning = "object on which it acts"}, self.object);
            visit(FieldInfo{.key = "force",
                            .unit = "N",
                            .meaning = "sum of the forces of all magnets on all its poles",
                            .adds = true},
                  self.force);
            visit(FieldInfo{.key = "point", .unit = "m", .meaning = "where it acts, in the world"},
                  self.point);
        }
    };
    struct Rate {
        ObjectId object;
        double rate = 0; ///< 1/s, at which the forces on the object vary as it moves; see StateRate
        template <class Self, class Visitor>
        static void describe(Self& self, Visitor&& visit) {
            visit(FieldInfo{.key = "object", .unit = "", .meaning = "the object that moves"}, self.object);
            visit(FieldInfo{.key = "rate",
                            .unit = "1/s",
                            .meaning = "at which the forces on it vary as it moves"},
                  self.rate);
        }
    };
    struct Brake {
        ObjectId object;
        Vec2 centre;        ///< m, its centre of mass, in the world
        double angular = 0; ///< kg m²/s: the torque is -angular times the angular velocity
        template <class Self, class Visitor>
        static void describe(Self& self, Visitor&& visit) {
            visit(FieldInfo{.key = "object", .unit = "", .meaning = "the object that turns"}, self.object);
            visit(FieldInfo{.key = "centre", .unit = "m", .meaning = "of its mass, in the world"},
                  self.centre);
            visit(FieldInfo{.key = "angular",
                            .unit = "kg m²/s",
                            .meaning = "the torque is -angular times the angular velocity"},
                  self.angular);
        }
    };
    /// What one object does to another one that can move, see MagneticActions.
    struct Action {
        ObjectId object;
        ObjectId by;      ///< the magnet, or the iron to which a magnet is drawn
        double force = 0; ///< N, sum of the amounts at all points of `object`
        bool push = false;
        EventId event; ///< its beginning
    };
    std::vector<Entry> forces;
    std::vector<Action> actions; ///< while tracing only; ascending by object, then by the acting object
    std::vector<Rate> rates;     ///< of objects with a mass, ascending
    std::vector<Brake> brakes;   ///< of soft objects with a mass that a pole acts on, ascending
    bool foreseen = false;       ///< whether forces are computed for the objects' later places

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "forces", .unit = "", .meaning = "one for each pole; ascending by object"},
              self.forces);
        visit(FieldInfo{.key = "rates", .unit = "", .meaning = "of what has a mass; ascending by object"},
              self.rates);
        visit(FieldInfo{.key = "brakes",
                        .unit = "",
                        .meaning = "of what a magnet pulls as it turns; ascending by object"},
              self.brakes);
        visit(FieldInfo{.key = "foreseen",
                        .unit = "",
                        .meaning = "whether forces are those of where objects will be when they act"},
              self.foreseen);
    }
};

} // namespace trembler
