// The settings with which the world's solver works.
#pragma once

#include "runtime/property/coverage.hpp"
#include "runtime/property/description.hpp"

namespace trembler {

/// The numbers with which Dynamics computed the last frame. With automatic settings they follow from the
/// scene's bodies, joints and contacts, and from the forces on them. For display only: other effects read
/// ForceLag.
struct SolverChoice {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{
        "Solver choice", "solver_choice",
        "The accuracy settings with which the last frame's motion was computed."};
    static constexpr Coverage coverage = hashed;
    static constexpr std::string_view standing = "the current accuracy settings";
    std::int32_t substeps = 4;
    std::int32_t velocityIterations = 8;
    bool jointsAtOnce = false;
    double scale = 4;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "substeps", .unit = "", .meaning = "steps of the engine in the frame"},
              self.substeps);
        visit(FieldInfo{.key = "velocity_iterations",
                        .unit = "",
                        .meaning = "velocity iterations of the solver per substep"},
              self.velocityIterations);
        visit(FieldInfo{.key = "joints_at_once",
                        .unit = "",
                        .meaning = "whether joints were solved exactly, as one system of equations"},
              self.jointsAtOnce);
        visit(FieldInfo{.key = "scale", .unit = "1/m", .meaning = "units of length of the engine per metre"},
              self.scale);
    }
    friend bool operator==(SolverChoice const&, SolverChoice const&) = default;
};

} // namespace trembler
