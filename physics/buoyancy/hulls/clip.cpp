#include "physics/buoyancy/hulls/clip.hpp"

#include <algorithm>

namespace trembler {

void ClippedPolygon::clip(Side const& side, int tag) {
    std::array<double, capacity> outside; // distances; positive: cut away
    bool anyOut = false;
    bool anyIn = false;
    for (std::size_t i = 0; i < count_; ++i) {
        outside[i] = dot(side.normal, corners_[i]) - side.offset;
        anyOut = anyOut || outside[i] > 0;
        anyIn = anyIn || outside[i] < 0;
    }
    if (!anyOut || !anyIn) {
        count_ = anyIn ? count_ : 0; // also removes a polygon that lies in the line: it has no area
        return;
    }
    std::array<Vec2, capacity> const corners = corners_;
    std::array<int, capacity> const tags = tags_;
    std::size_t const count = count_;
    count_ = 0;
    for (std::size_t i = 0; i < count; ++i) {
        std::size_t const next = i + 1 == count ? 0 : i + 1;
        bool const in = !(outside[i] > 0);
        bool const nextIn = !(outside[next] > 0);
        if (in) {
            add(corners[i], tags[i]);
        }
        if (in != nextIn) {
            double const share = outside[i] / (outside[i] - outside[next]);
            Vec2 const crossing = corners[i] + share * (corners[next] - corners[i]);
            add(crossing, in ? tag : tags[i]);
        }
    }
}

} // namespace trembler
