// Switches electromagnets.
#pragma once

#include "physics/magnetism/calls.hpp"
#include "physics/magnetism/properties.hpp"
#include "runtime/component/resolver.hpp"

namespace trembler {

class MagneticsResolver final : public Resolver<MagneticsResolver, MagneticsRole, Reads<Electromagnet>,
                                                Writes<Magnet>, Provides<MagnetSwitching>> {
public:
    static constexpr ComponentText text{
        .name = "Magnetics",
        .effect = "magnetism",
        .level = "",
        .work = "Switches electromagnets as requested by the interaction functions: "
                "on at once, off over a few frames of cooling down."};
    using Activation = NeedsAny<Magnet>;
    static constexpr Coverage memory = leftOut("whether any magnet cools down, as Magnet on/off states");

    [[nodiscard]] bool restless() const { return cooling_; }
    void advance(Access& access);

private:
    bool cooling_ = false;
};

} // namespace trembler
