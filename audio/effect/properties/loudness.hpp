// The loudness at listening objects, derived by the Loudness sets.
#pragma once

#include "runtime/object/object_id.hpp"
#include "runtime/property/description.hpp"
#include "runtime/trace/event.hpp"

#include <string_view>
#include <vector>

namespace trembler {

/// Derived by the present detail level of loudness.
struct Loudness {
    static constexpr PropertyKind kind = PropertyKind::derived;
    static constexpr PropertyText text{"Loudness", "loudness", "The sound level at each listening object."};
    static constexpr std::string_view standing = "the level of the sounds at their end, smoothed over 125 ms";
    struct Entry {
        ObjectId ear;
        double level = 0; ///< dB(A), "fast"; silentLevel in silence
        ObjectId loudest; ///< the object that contributes most; invalid in silence
        EventId event;    ///< made the loudest one sound; none without tracing
        template <class Self, class Visitor>
        static void describe(Self& self, Visitor&& visit) {
            visit(FieldInfo{.key = "object", .unit = "", .meaning = "listening object"}, self.ear);
            visit(FieldInfo{.key = "level", .unit = "dB(A)", .meaning = "sound level at it"}, self.level);
            visit(FieldInfo{.key = "loudest", .unit = "", .meaning = "object whose sound contributes most"},
                  self.loudest);
        }
    };
    std::vector<Entry> entries; ///< ascending by ear

    /// The level at an object that listens; silentLevel for others.
    [[nodiscard]] double at(ObjectId ear) const;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "entries", .unit = "", .meaning = "ascending by object"}, self.entries);
    }
};

} // namespace trembler
