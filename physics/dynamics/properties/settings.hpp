// How exactly a world's rigid bodies are computed.
#pragma once

#include "runtime/property/description.hpp"

namespace trembler {

/// How strong the player's hands are, whatever they hold: a hand pulls a heavy object no harder than a light
/// one. A world that does not state its hands has the default strength.
struct Hands {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "Hands", "hands",
        "How hard each of the player's two hands can pull. A world that does not "
        "state it has hands of 3000 N, which lift 306 kg on Earth.",
        PropertyPlace::world};
    double strength = 3000; ///< N; lifts each single part of the game on Earth, the heaviest has 221 kg

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "strength",
                        .unit = "N",
                        .meaning = "greatest force of one hand, whatever it holds; 500 lifts 51 kg on Earth",
                        .minimum = 0,
                        .maximum = 1e9},
              self.strength);
    }
};

/// Substeps are better than iterations at equal cost: a stack or a taut chain fails because of the length of
/// the step, not of the convergence within it. The number that suffices depends on the scene, see
/// solver_demand.hpp; an ordinary one gets four.
struct DynamicsSettings {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "Solver", "solver", "How exactly the motion of rigid bodies is computed.", PropertyPlace::world};
    static constexpr std::int32_t automatic = 0; ///< as many as the scene needs, but at least four
    std::int32_t substeps = automatic;
    std::int32_t velocityIterations = 8;
    std::int32_t positionIterations = 3;
    /// Box2D is made for bodies of 0.1 to 10 units and keeps shapes 0.015 units apart; parts of levels
    /// measure decimetres. Powers of two lose no bits. 0: automatic, from the sizes of shapes.
    double scale = 0;
    bool sleeping = true;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(
            FieldInfo{.key = "substeps",
                      .unit = "",
                      .meaning = "steps of the engine in a frame; 0: as many as the scene needs, at least 4",
                      .minimum = 0,
                      .maximum = 64,
                      .accuracy = {0, 64}},
            self.substeps);
        visit(FieldInfo{.key = "velocity_iterations",
                        .unit = "",
                        .meaning = "velocity iterations of the solver per substep",
                        .minimum = 1,
                        .maximum = 256,
                        .accuracy = {1, 256}},
              self.velocityIterations);
        visit(FieldInfo{.key = "position_iterations",
                        .unit = "",
                        .meaning = "position iterations of the solver per substep",
                        .minimum = 1,
                        .maximum = 256,
                        .accuracy = {1, 256}},
              self.positionIterations);
        visit(
            FieldInfo{
                .key = "scale",
                .unit = "1/m",
                .meaning =
                    "units of length of the engine per metre; 0: chosen by the sizes of shapes, at least 4",
                .minimum = 0,
                .maximum = 64,
                .accuracy = {0, 64}},
            self.scale);
        visit(FieldInfo{.key = "sleeping",
                        .unit = "",
                        .meaning = "whether bodies at rest are skipped until they are disturbed"},
              self.sleeping);
    }
    friend bool operator==(DynamicsSettings const&, DynamicsSettings const&) = default;
};

} // namespace trembler
