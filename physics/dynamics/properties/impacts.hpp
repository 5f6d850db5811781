// Impacts: the places and impulses of collisions within a frame.
#pragma once

#include "runtime/math/vec2.hpp"
#include "runtime/property/coverage.hpp"
#include "runtime/property/description.hpp"
#include "runtime/property/news.hpp"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace trembler {

/// One impact. A frame has several substeps, so a pair can collide several times within it.
struct Impact {
    ObjectId a; ///< a < b
    ObjectId b;
    Vec2 point;         ///< m, in the world
    Vec2 normal;        ///< unit, in the world, from a to b
    double impulse = 0; ///< N s, along the normal, less that of the pressure before it
    double since = 0;   ///< s, from the beginning of the frame, or of the part that reports it

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "a", .unit = "", .meaning = "first object"}, self.a);
        visit(FieldInfo{.key = "b", .unit = "", .meaning = "second object"}, self.b);
        visit(FieldInfo{.key = "point", .unit = "m", .meaning = "point of the impact, in the world"},
              self.point);
        visit(FieldInfo{.key = "normal", .unit = "", .meaning = "from the first object to the second"},
              self.normal);
        visit(FieldInfo{.key = "impulse", .unit = "N s", .meaning = "along the normal"}, self.impulse);
        visit(FieldInfo{.key = "since", .unit = "s", .meaning = "since the beginning of the frame"},
              self.since);
    }
};

/// Computed only while a component or a subscription reads it. Steady pressure is no impact, and neither is a
/// collision that changes the relative speed by less than 2 cm/s.
struct Impacts {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Impacts", "impacts",
                                       "The impacts of this frame: objects, points and impulses."};
    static constexpr Coverage coverage = derivedFrom(
        "the engine's contacts of the last advance; the results of interactions that read them are in calls");
    std::vector<Impact> impacts; ///< ascending by pair, then by time

    static void gather(Impacts& frame, Impacts const& part, PartSpan span);

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "impacts", .unit = "", .meaning = "ascending by pair, then by time"},
              self.impacts);
    }
};

inline constexpr double faintestImpact = 0.02; ///< m/s, change of the relative speed

/// Stores the impulse of each contact of an engine, to distinguish impacts from pressure.
class ImpactBook {
public:
    /// Identifies a contact while it exists. Looked up, never iterated over.
    using Key = std::uint64_t;

    /// To be called for a new contact: its impulse so far is 0.
    void begin(Key contact) { pressed_[contact] = 0; }
    void end(Key contact) { pressed_.erase(contact); }
    void clear() { pressed_.clear(); }
    /// The increase of a contact's impulse in this substep; 0 for an unknown contact, as it may have had this
    /// impulse before.
    double press(Key contact, double impulse);

private:
    std::unordered_map<Key, double> pressed_;
};

} // namespace trembler
