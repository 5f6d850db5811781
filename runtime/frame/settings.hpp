// Into how many parts a world's frames are divided.
#pragma once

#include "runtime/property/description.hpp"

namespace trembler {

/// The most parts of a frame. Each of 1, 2, 4 and 8 divides it, so times are exact.
inline constexpr int mostParts = 8;

/// A frame is the time step at which simulations exchange data. Coupled quantities that vary faster need
/// shorter steps: in a frame of n equal parts every resolver advances, every derived property set updates and
/// every interaction applies n times.
struct FrameSettings {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Frame", "frame", "How finely the simulations are coupled.",
                                       PropertyPlace::world};
    static constexpr std::int32_t automatic = 0; ///< as many as interactions request: see SplitFrame
    std::int32_t parts = automatic;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "parts",
                        .unit = "",
                        .meaning = "number of equal parts in which a frame is computed: 1, 2, 4 or 8 (others "
                                   "are rounded up); 0: as many as the scene needs",
                        .minimum = 0,
                        .maximum = mostParts,
                        .accuracy = {0, mostParts}},
              self.parts);
    }
    friend bool operator==(FrameSettings const&, FrameSettings const&) = default;
};

/// The smallest of 1, 2, 4 and 8 that is at least `wanted`, or 8.
[[nodiscard]] constexpr int roundedParts(double wanted) {
    int parts = 1;
    while (parts < mostParts && parts < wanted) {
        parts *= 2;
    }
    return parts;
}

} // namespace trembler
