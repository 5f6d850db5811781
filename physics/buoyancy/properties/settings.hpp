// How exactly a world's buoyancy is computed.
#pragma once

#include "runtime/property/description.hpp"

namespace trembler {

struct BuoyancySettings {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Buoyancy settings", "buoyancy", "How exactly buoyancy is computed.",
                                       PropertyPlace::world};
    std::int32_t particles = 64;
    /// A force that stands for a while acts as if it came half of this while too late, which feeds
    /// oscillations. See LiquidDrag.
    bool lookAhead = true;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "particles",
                        .unit = "",
                        .meaning = "that stand for a body at the detail level \"particles\"",
                        .minimum = 4,
                        .maximum = 256,
                        .accuracy = {4, 256}},
              self.particles);
        visit(FieldInfo{.key = "look_ahead",
                        .unit = "",
                        .meaning = "whether a body resists what its motion will change about its buoyancy "
                                   "before that is computed again"},
              self.lookAhead);
    }
    friend bool operator==(BuoyancySettings const&, BuoyancySettings const&) = default;
};

} // namespace trembler
