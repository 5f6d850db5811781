// (Electricity <- Fuses): a fuse that carries more than its rating melts.
#pragma once

#include "physics/electricity/calls.hpp"
#include "physics/electricity/properties/quantities.hpp"
#include "physics/electricity/properties/ratings.hpp"
#include "runtime/component/interaction.hpp"

namespace trembler {

/// Of several overloaded fuses in one circuit the most overloaded one melts first, as it is the fastest;
/// equals melt together. The others can melt in the next frame if they are still overloaded. With levels that
/// compute no currents, no fuse melts.
class ElectricityFromFuses final
    : public Interaction<ElectricityFromFuses, ElectricityRole, Reads<ElectricalQuantities, Fuse>> {
public:
    static constexpr ComponentText text{.name = "Electricity <- Fuses",
                                        .effect = "electricity",
                                        .level = "",
                                        .work = "Blows, in every circuit, the most overloaded fuse."};
    /// Overloads that differ by no more than this share count as equal, because of rounding.
    static constexpr double equality = 1e-9;
    using Activation = NeedsAll<Fuse>;
    void apply(Access& access);
};

} // namespace trembler
