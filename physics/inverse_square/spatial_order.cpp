#include "physics/inverse_square/spatial_order.hpp"

#include <algorithm>
#include <tuple>

namespace trembler::inverse_square {
namespace {

// Spreads the bits of v, with every second bit free for the other coordinate.
std::uint64_t spread(std::uint32_t v) {
    std::uint64_t bits = v;
    bits = (bits | (bits << 16U)) & 0x0000FFFF0000FFFFULL;
    bits = (bits | (bits << 8U)) & 0x00FF00FF00FF00FFULL;
    bits = (bits | (bits << 4U)) & 0x0F0F0F0F0F0F0F0FULL;
    bits = (bits | (bits << 2U)) & 0x3333333333333333ULL;
    return (bits | (bits << 1U)) & 0x5555555555555555ULL;
}

std::uint32_t step(double t) {
    static constexpr double steps = 4294967296.0;
    double const scaled = t * steps;
    if (!(scaled > 0)) { // NaN must not be converted
        return 0;
    }
    return scaled >= steps ? 0xFFFFFFFFU : static_cast<std::uint32_t>(scaled);
}

} // namespace

void orderAlongCurve(Points const& points, std::vector<Ordered>& order) {
    std::size_t const count = points.size();
    order.resize(count);
    if (count == 0) {
        return;
    }
    auto const [left, right] = std::minmax_element(points.x.begin(), points.x.end());
    auto const [low, high] = std::minmax_element(points.y.begin(), points.y.end());
    double const extent = std::max(*right - *left, *high - *low);
    double const inverse = extent > 0 ? 1 / extent : 0;
    for (std::size_t i = 0; i < count; ++i) {
        order[i] = {spread(step((points.x[i] - *left) * inverse)) |
                        (spread(step((points.y[i] - *low) * inverse)) << 1U),
                    static_cast<std::uint32_t>(i)};
    }
    sortByKeyAndPoint(points, order);
}

void sortByKeyAndPoint(Points const& points, std::vector<Ordered>& order) {
    auto const rest = [&](std::uint32_t i) {
        return std::tie(points.x[i], points.y[i], points.weight[i], points.owner[i]);
    };
    std::sort(order.begin(), order.end(), [&](Ordered const& a, Ordered const& b) {
        return a.key != b.key ? a.key < b.key : rest(a.row) < rest(b.row);
    });
}

void copyInOrder(Points const& points, std::vector<Ordered> const& order, Points& into) {
    into.clear();
    for (Ordered const& o : order) {
        into.add(points.at(o.row), points.weight[o.row], points.owner[o.row]);
    }
}

} // namespace trembler::inverse_square
