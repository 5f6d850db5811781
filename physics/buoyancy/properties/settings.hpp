// How exactly a world's buoyancy is computed.
#pragma once

#include "runtime/property/description.hpp"

namespace trembler {

struct BuoyancySettings {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Buoyancy settings", "buoyancy", "How exactly buoyancy is computed.",
                                       PropertyPlace::world};
    std::int32_t particles = 64;
    /// Compensates the delay of held forces, which adds energy to oscillations: a force that is held for a
    /// time acts, on average, half of this time too late. See LiquidDrag.
    bool lookAhead = true;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "particles",
                        .unit = "",
                        .meaning =
                            "number of particles that represent a body at the detail level \"particles\"",
                        .minimum = 4,
                        .maximum = 256,
                        .accuracy = {4, 256}},
              self.particles);
        visit(FieldInfo{.key = "look_ahead",
                        .unit = "",
                        .meaning = "whether a damping makes up for the change of a body's buoyancy until it "
                                   "is computed again"},
              self.lookAhead);
    }
    friend bool operator==(BuoyancySettings const&, BuoyancySettings const&) = default;
};

} // namespace trembler
