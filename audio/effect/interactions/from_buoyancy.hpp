// (Sound <- Buoyancy): objects that fall into a liquid splash.
#pragma once

#include "audio/effect/calls.hpp"
#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/buoyancy/properties/results.hpp"
#include "physics/material.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/placement.hpp"

#include <map>

namespace trembler {

/// The liquid that a body newly displaces in a frame gets the body's speed; its momentum is the impact that
/// makes bubbles. A body that floats, or leaves the liquid, is silent.
class SoundFromBuoyancy final
    : public Interaction<SoundFromBuoyancy, SoundRole, Reads<Immersions, Position, Rotation, Velocity>> {
public:
    static constexpr ComponentText text{
        .name = "Sound <- Buoyancy",
        .effect = "sound",
        .level = "",
        .work =
            "Excites a liquid by the momentum that an object gives to the liquid that it newly displaces."};
    using Activation = NeedsAll<Liquid>;
    /// The memory is hashed, as splashes depend on the areas that were immersed before.
    void hashMemory(StateHash& hash) const { hash.members(wet_); }

    static constexpr double slowest = 0.1;  ///< m/s into the liquid; slower bodies make no splash
    static constexpr double contact = 1e-4; ///< s: bubbles close very fast

    void apply(Access& access);

private:
    std::map<std::pair<ObjectId, ObjectId>, double> wet_; // m², by object and liquid, of the last apply
    std::map<std::pair<ObjectId, ObjectId>, double> wetNow_;
};

} // namespace trembler
