// The state of a world whose engine could not go on.
#pragma once

#include "runtime/property/coverage.hpp"
#include "runtime/property/description.hpp"

#include <string>
#include <vector>

namespace trembler {

/// Nothing, as a rule. A world that asks too much of its engine goes on with Box2D from the frame on in which
/// that happened; where Box2D itself loses a body's numbers, that body stands still from then on. Part of the
/// state: the same in every run, on any number of threads.
struct EngineState {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Engine state", "engine_state",
                                       "Which engine had to give up, why, and what stands still since."};
    static constexpr Coverage coverage = hashed;
    static constexpr std::string_view standing = "which engine has given up, and what stands still since";
    std::string gaveUp;            ///< detail level of Dynamics; empty: none
    std::string why;               ///< the first reason
    std::vector<ObjectId> stopped; ///< ascending

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "gave_up", .unit = "", .meaning = "detail level that could not go on"},
              self.gaveUp);
        visit(FieldInfo{.key = "why", .unit = "", .meaning = "what it said"}, self.why);
        visit(FieldInfo{.key = "stopped", .unit = "", .meaning = "objects that stand still since"},
              self.stopped);
    }
    friend bool operator==(EngineState const&, EngineState const&) = default;
    /// Whether anything has gone wrong.
    [[nodiscard]] bool troubled() const { return !gaveUp.empty() || !stopped.empty(); }
};

} // namespace trembler
