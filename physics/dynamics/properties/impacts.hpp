// Impacts: where two bodies hit each other within a frame, and how hard.
#pragma once

#include "runtime/math/vec2.hpp"
#include "runtime/property/coverage.hpp"
#include "runtime/property/description.hpp"
#include "runtime/property/news.hpp"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace trembler {

/// One impact. A frame has several substeps, so a pair can meet, part and meet again within it.
struct Impact {
    ObjectId a; ///< a < b
    ObjectId b;
    Vec2 point;         ///< m, in the world
    Vec2 normal;        ///< unit, in the world, from a to b
    double impulse = 0; ///< N s, along the normal, beyond the pressure there before
    double since = 0;   ///< s, from the beginning of the frame, or of the part that reports it

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "a", .unit = "", .meaning = "one object"}, self.a);
        visit(FieldInfo{.key = "b", .unit = "", .meaning = "the other"}, self.b);
        visit(FieldInfo{.key = "point", .unit = "m", .meaning = "where they hit, in the world"}, self.point);
        visit(FieldInfo{.key = "normal", .unit = "", .meaning = "from the one to the other"}, self.normal);
        visit(FieldInfo{.key = "impulse", .unit = "N s", .meaning = "along the normal"}, self.impulse);
        visit(FieldInfo{.key = "since", .unit = "s", .meaning = "since the beginning of the frame"},
              self.since);
    }
};

/// Computed only while a component reads it, or a subscription wants it. Steady pressure is no impact, and
/// neither is one that changes the speed of the two by less than 2 cm/s.
struct Impacts {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Impacts", "impacts",
                                       "Where objects hit each other in this frame, and how hard."};
    static constexpr Coverage coverage = derivedFrom(
        "the engine's contacts of the last advance; what interactions make of them is in their calls");
    std::vector<Impact> impacts; ///< ascending by pair, then by time

    static void gather(Impacts& frame, Impacts const& part, PartSpan span);

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "impacts", .unit = "", .meaning = "ascending by pair, then by time"},
              self.impacts);
    }
};

inline constexpr double faintestImpact = 0.02; ///< m/s, change of the relative speed

/// Remembers how hard each contact of an engine presses, to distinguish impacts from pressure.
class ImpactBook {
public:
    /// Names a contact for as long as it exists. Looked up, never walked.
    using Key = std::uint64_t;

    /// A contact has come into being: nothing has pressed there yet.
    void begin(Key contact) { pressed_[contact] = 0; }
    void end(Key contact) { pressed_.erase(contact); }
    void clear() { pressed_.clear(); }
    /// By how much a contact is pressed harder, in this substep, than it was before; 0 for one that is not
    /// known yet, as it may have been so all along.
    double press(Key contact, double impulse);

private:
    std::unordered_map<Key, double> pressed_;
};

} // namespace trembler
