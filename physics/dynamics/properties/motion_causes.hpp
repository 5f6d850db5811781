// The causes of motion, joint forces and overloaded joints: resolver properties computed when read.
#pragma once

#include "physics/dynamics/properties/joint.hpp"
#include "runtime/property/coverage.hpp"
#include "runtime/property/news.hpp"
#include "runtime/trace/event.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

namespace trembler {

/// The recent causes of each object's motion: forces, impulses and contacts, including those passed on
/// through joints and contacts. Kept only while tracing is on and a component reads it.
struct MotionCauses {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Causes of motion", "motion_causes",
                                       "The recent events that made each object move."};
    static constexpr std::string_view standing = "the recent causes, not those of a part";
    static constexpr Coverage coverage =
        leftOut("events of the trace, kept only while tracing; events have no effect");
    struct Entry {
        ObjectId object;
        std::vector<EventId> causes; ///< ascending
    };
    std::vector<Entry> entries; ///< ascending by object

    /// The causes of an object's motion; may be empty.
    [[nodiscard]] std::vector<EventId> of(ObjectId object) const {
        auto const at = std::lower_bound(entries.begin(), entries.end(), object,
                                         [](Entry const& entry, ObjectId id) { return entry.object < id; });
        return at == entries.end() || at->object != object ? std::vector<EventId>{} : at->causes;
    }
};

/// The force of each joint, as a mean over the last frame in which any body moved.
struct JointForces {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Joint forces", "joint_forces", "The force that each joint exerts."};
    static constexpr std::string_view standing = "the forces of joints";
    static constexpr Coverage coverage =
        derivedFrom("the forces of the engine's joints in the last advance; computed only while read");
    struct Entry {
        ObjectId joint;
        Vec2 force; ///< N
        template <class Self, class Visitor>
        static void describe(Self& self, Visitor&& visit) {
            visit(FieldInfo{.key = "object", .unit = "", .meaning = "the joint"}, self.joint);
            visit(FieldInfo{.key = "force", .unit = "N", .meaning = "force that it exerts"}, self.force);
        }
    };
    std::vector<Entry> entries; ///< ascending by joint

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "entries", .unit = "", .meaning = "ascending by joint"}, self.entries);
    }
};

/// The joints that were loaded beyond their breaking force in this frame.
struct OverloadedJoints {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Overloaded joints", "overloaded_joints",
                                       "The joints whose force exceeded their breaking force in this frame."};
    static constexpr Coverage coverage = hashed;
    struct Entry {
        ObjectId joint;
        EventId event; ///< "joint overloaded"; none without tracing
        template <class Self, class Visitor>
        static void describe(Self& self, Visitor&& visit) {
            visit(FieldInfo{.key = "object", .unit = "", .meaning = "the joint"}, self.joint);
        }
    };
    std::vector<Entry> entries; ///< ascending by joint

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "entries", .unit = "", .meaning = "ascending by joint"}, self.entries);
    }
    /// A joint that is overloaded in several parts of a frame is reported once, as in the first of them.
    static void gather(OverloadedJoints& frame, OverloadedJoints const& part, PartSpan) {
        std::vector<Entry> all;
        std::set_union(frame.entries.begin(), frame.entries.end(), part.entries.begin(), part.entries.end(),
                       std::back_inserter(all),
                       [](Entry const& a, Entry const& b) { return a.joint < b.joint; });
        frame.entries = std::move(all);
    }
};

} // namespace trembler
