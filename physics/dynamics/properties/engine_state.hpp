// The failures of a world's engine.
#pragma once

#include "runtime/property/coverage.hpp"
#include "runtime/property/description.hpp"

#include <string>
#include <vector>

namespace trembler {

/// Usually empty. If an engine fails, Box2D computes the motion from that frame on; if a body's numbers in
/// Box2D are not finite, that body is held still from then on. Part of the state: the same in every run, on
/// any number of threads.
struct EngineState {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{
        "Engine state", "engine_state",
        "The engine that failed, its error, and the bodies that are held still since then."};
    static constexpr Coverage coverage = hashed;
    static constexpr std::string_view standing =
        "which engine has failed, and which bodies are held still since";
    std::string gaveUp;            ///< detail level of Dynamics; empty: none
    std::string why;               ///< the first reason
    std::vector<ObjectId> stopped; ///< ascending

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "gave_up", .unit = "", .meaning = "detail level whose engine failed"},
              self.gaveUp);
        visit(FieldInfo{.key = "why", .unit = "", .meaning = "error of the engine"}, self.why);
        visit(FieldInfo{.key = "stopped", .unit = "", .meaning = "objects that are held still since then"},
              self.stopped);
    }
    friend bool operator==(EngineState const&, EngineState const&) = default;
    /// Whether any engine has failed.
    [[nodiscard]] bool troubled() const { return !gaveUp.empty() || !stopped.empty(); }
};

} // namespace trembler
