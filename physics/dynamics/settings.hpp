// How exactly a world's rigid bodies are computed.
#pragma once

#include "runtime/property/description.hpp"

namespace trembler {

/// Substeps beat iterations at equal cost: what breaks a stack or a taut chain is the length of the step, not
/// the convergence within it. Four hold a stack of fifty boxes and a chain under a hundred times its links'
/// mass.
struct DynamicsSettings {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "Solver", "solver", "How exactly the motion of rigid bodies is computed.", PropertyPlace::world};
    std::int32_t substeps = 4;
    std::int32_t velocityIterations = 8;
    std::int32_t positionIterations = 3;
    /// Box2D is made for things of 0.1 to 10 units and keeps shapes 0.015 units apart; its parts here are
    /// decimetres. Powers of two lose no bits.
    double scale = 4;
    bool sleeping = true;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "substeps",
                        .unit = "",
                        .meaning = "steps of the engine in a frame",
                        .minimum = 1,
                        .maximum = 64},
              self.substeps);
        visit(FieldInfo{.key = "velocity_iterations",
                        .unit = "",
                        .meaning = "of the solver, per substep",
                        .minimum = 1,
                        .maximum = 256},
              self.velocityIterations);
        visit(FieldInfo{.key = "position_iterations",
                        .unit = "",
                        .meaning = "of the solver, per substep",
                        .minimum = 1,
                        .maximum = 256},
              self.positionIterations);
        visit(FieldInfo{.key = "scale",
                        .unit = "1/m",
                        .meaning = "units of length of the engine per metre",
                        .minimum = 1,
                        .maximum = 64},
              self.scale);
        visit(FieldInfo{.key = "sleeping",
                        .unit = "",
                        .meaning = "bodies at rest are left out until disturbed"},
              self.sleeping);
    }
    friend bool operator==(DynamicsSettings const&, DynamicsSettings const&) = default;
};

} // namespace trembler
