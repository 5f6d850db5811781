#include "render/panels/name_places.hpp"

#include <algorithm>
#include <array>

namespace trembler::render {
namespace {

constexpr std::size_t mostNames = 400;
constexpr double besideObject = 4; // pixels between an object and its name

struct NameFrame {
    Point low;
    Point high;
};

double overlapOf(NameFrame const& a, NameFrame const& b) {
    double const x = std::min(a.high.x, b.high.x) - std::max(a.low.x, b.low.x);
    double const y = std::min(a.high.y, b.high.y) - std::max(a.low.y, b.low.y);
    return x > 0 && y > 0 ? x * y : 0;
}

double areaOf(NameFrame const& frame) {
    return std::max(frame.high.x - frame.low.x, 0.0) * std::max(frame.high.y - frame.low.y, 0.0);
}

NameFrame around(Point middle, Point size) {
    return {middle - 0.5 * size, middle + 0.5 * size};
}

/// Places around the object: below first, the usual one, then the other sides; and all of them again at the
/// distance of a name's height.
std::array<Point, 16> placesAround(NamedBox const& box) {
    std::array<Point, 16> all{};
    Point const middle = 0.5 * (box.low + box.high);
    std::size_t next = 0;
    for (double const more : {0.0, 1.0}) {
        double const away = besideObject + more * (box.size.y + besideObject);
        double const right = box.high.x + away + 0.5 * box.size.x;
        double const left = box.low.x - away - 0.5 * box.size.x;
        double const below = box.high.y + away + 0.5 * box.size.y;
        double const above = box.low.y - away - 0.5 * box.size.y;
        for (Point const place :
             {Point{middle.x, below}, Point{middle.x, above}, Point{right, middle.y}, Point{left, middle.y},
              Point{right, below}, Point{left, below}, Point{right, above}, Point{left, above}}) {
            all[next++] = place;
        }
    }
    return all;
}

/// The area that a name hides at a place, in square pixels, increased for places that are less suitable.
class NameCost {
public:
    NameCost(std::span<NamedBox const> boxes, Point screen, std::vector<NameFrame> const& placed)
        : boxes_(boxes), screen_{Point{}, screen}, placed_(placed) {}

    [[nodiscard]] double of(NameFrame const& name, std::size_t owner) const {
        double const own = areaOf(name);
        double cost = 8 * (own - overlapOf(name, screen_));
        for (NameFrame const& other : placed_) {
            cost += 4 * overlapOf(name, other);
        }
        for (std::size_t i = 0; i < boxes_.size(); ++i) {
            NameFrame const object{boxes_[i].low, boxes_[i].high};
            if (i != owner && areaOf(object) < 4 * own) { // a larger one is seen behind it
                cost += overlapOf(name, object);
            }
        }
        return cost;
    }

private:
    std::span<NamedBox const> boxes_;
    NameFrame screen_;
    std::vector<NameFrame> const& placed_;
};

} // namespace

std::vector<Point> namePlaces(std::span<NamedBox const> boxes, Point screen) {
    std::vector<Point> places;
    places.reserve(boxes.size());
    std::vector<NameFrame> placed;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        NamedBox const& box = boxes[i];
        Point best = 0.5 * (box.low + box.high);
        NameCost const cost(boxes, screen, placed);
        bool const fits = box.size.x <= box.high.x - box.low.x && box.size.y <= box.high.y - box.low.y;
        if (boxes.size() <= mostNames) {
            double least = fits ? cost.of(around(best, box.size), i) : -1;
            double reluctance = 0;
            for (Point const place : placesAround(box)) {
                reluctance += 0.01 * box.size.x * box.size.y;
                double const there = cost.of(around(place, box.size), i) + reluctance;
                if (least < 0 || there < least) {
                    least = there;
                    best = place;
                }
            }
        }
        placed.push_back(around(best, box.size));
        places.push_back(best);
    }
    return places;
}

} // namespace trembler::render
