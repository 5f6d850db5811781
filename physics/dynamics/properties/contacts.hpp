// The objects that touch: the resolver properties C_C, C_N and C_P (6.13.2), and the geometry and impulses of
// contacts.
#pragma once

#include "runtime/property/coverage.hpp"
#include "runtime/property/description.hpp"
#include "runtime/property/news.hpp"
#include "runtime/trace/event.hpp"

#include <array>
#include <vector>

namespace trembler {

/// Two objects that touch; a < b.
struct TouchingPair {
    ObjectId a;
    ObjectId b;
    EventId event; ///< "contact begun", or "contact ended" in Contacts::ended; none without tracing

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "a", .unit = "", .meaning = "one object"}, self.a);
        visit(FieldInfo{.key = "b", .unit = "", .meaning = "the other"}, self.b);
    }
    friend constexpr bool operator<(TouchingPair const& x, TouchingPair const& y) {
        return x.a != y.a ? x.a < y.a : x.b < y.b;
    }
    friend constexpr bool operator==(TouchingPair const& x, TouchingPair const& y) {
        return x.a == y.a && x.b == y.b;
    }
};

/// All lists are ascending by pair. A contact that begins and ends within one frame, or one part of it, for
/// example an impact that bounces, is in `brief` only.
struct Contacts {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{
        "C_C, C_N, C_P", "contacts",
        "The pairs of objects that touch, the pairs that began to touch in this frame, and "
        "the pairs that ceased to."};
    static constexpr Coverage coverage = hashed;
    std::vector<TouchingPair> current; ///< C_C
    std::vector<TouchingPair> begun;   ///< C_N
    std::vector<TouchingPair> ended;   ///< C_P; its objects may no longer exist
    std::vector<TouchingPair> brief;   ///< touched within this frame only; in no other list

    /// For a frame in parts: the pairs that touch at its end, the pairs that began and ceased to touch since
    /// its beginning, and the pairs that touched only in between, in any part. With the event of the first
    /// part that reports the pair.
    static void gather(Contacts& frame, Contacts const& part, PartSpan span);

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "current", .unit = "", .meaning = "pairs that touch"}, self.current);
        visit(FieldInfo{.key = "begun", .unit = "", .meaning = "pairs that began to touch in the frame"},
              self.begun);
        visit(FieldInfo{.key = "ended", .unit = "", .meaning = "pairs that ceased to touch in the frame"},
              self.ended);
        visit(FieldInfo{.key = "brief", .unit = "", .meaning = "pairs that touched within the frame only"},
              self.brief);
    }
};

/// The geometry and the impulses of a pair's contact.
struct ContactPatch {
    ObjectId a;
    ObjectId b;
    Vec2 normal;                          ///< unit, in the world, from a to b
    std::array<Vec2, 2> points;           ///< m, in the world
    std::array<double, 2> normalImpulse;  ///< N s in the last substep
    std::array<double, 2> tangentImpulse; ///< N s in the last substep
    int count = 0;                        ///< number of points in use, 1 or 2

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "a", .unit = "", .meaning = "one object"}, self.a);
        visit(FieldInfo{.key = "b", .unit = "", .meaning = "the other"}, self.b);
        visit(FieldInfo{.key = "normal", .unit = "", .meaning = "from the one to the other, in the world"},
              self.normal);
        visit(FieldInfo{.key = "count", .unit = "", .meaning = "number of points, 1 or 2"}, self.count);
        visit(FieldInfo{.key = "point", .unit = "m", .meaning = "first point, in the world"}, self.points[0]);
        visit(FieldInfo{.key = "impulse", .unit = "N s", .meaning = "there, along the normal, in a step"},
              self.normalImpulse[0]);
        visit(FieldInfo{.key = "friction", .unit = "N s", .meaning = "there, across the normal, in a step"},
              self.tangentImpulse[0]);
        visit(FieldInfo{.key = "second_point", .unit = "m", .meaning = "second point, if there are two"},
              self.points[1]);
        visit(FieldInfo{.key = "second_impulse", .unit = "N s", .meaning = "there, along the normal"},
              self.normalImpulse[1]);
        visit(FieldInfo{.key = "second_friction", .unit = "N s", .meaning = "there, across the normal"},
              self.tangentImpulse[1]);
    }
};

/// Computed only while a component or a subscription reads it. Ascending by pair; a compound may touch in
/// several patches.
struct ContactPatches {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Contact patches", "contact_patches",
                                       "Points, normals and impulses of all contacts."};
    static constexpr std::string_view standing = "the geometry of the contacts that still exist";
    static constexpr Coverage coverage = derivedFrom(
        "the engine's contacts of the last advance; the results of interactions that read them are in calls");
    std::vector<ContactPatch> patches;
    double step = 0; ///< s, of that substep

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "patches", .unit = "", .meaning = "ascending by pair"}, self.patches);
        visit(FieldInfo{.key = "step", .unit = "s", .meaning = "length of the steps of the impulses"},
              self.step);
    }
};

} // namespace trembler
