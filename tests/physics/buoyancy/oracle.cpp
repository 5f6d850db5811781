#include "tests/physics/buoyancy/oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trembler::test {

Slab::Slab(ShapePiece const& piece, Vec2 at, double angle) {
    auto const place = [&](Vec2 p) { return at + rotated(piece.at + rotated(p, piece.angle), angle); };
    switch (piece.form) {
    case ShapeForm::circle:
        discs_ = {{place({}), piece.radius}};
        break;
    case ShapeForm::box:
        for (Vec2 const sign : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}}) {
            corners_.push_back(place({sign.x * piece.width / 2, sign.y * piece.height / 2}));
        }
        break;
    case ShapeForm::polygon:
        for (Vec2 const corner : piece.corners) {
            corners_.push_back(place(corner));
        }
        break;
    case ShapeForm::capsule: {
        double const half = piece.width / 2 - piece.radius;
        for (Vec2 const sign : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}}) {
            corners_.push_back(place({sign.x * half, sign.y * piece.radius}));
        }
        discs_ = {{place({-half, 0}), piece.radius}, {place({half, 0}), piece.radius}};
        break;
    }
    }
    heights_ = {std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
    for (Vec2 const corner : corners_) {
        heights_ = {std::min(heights_.from, corner.y), std::max(heights_.to, corner.y)};
    }
    for (Round const& disc : discs_) {
        heights_ = {std::min(heights_.from, disc.centre.y - disc.radius),
                    std::max(heights_.to, disc.centre.y + disc.radius)};
    }
}

std::optional<Slab::Interval> Slab::at(double y) const {
    std::optional<Interval> found;
    auto const include = [&](double from, double to) {
        found = found ? Interval{std::min(found->from, from), std::max(found->to, to)} : Interval{from, to};
    };
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        Vec2 const a = corners_[i];
        Vec2 const b = corners_[(i + 1) % corners_.size()];
        if ((a.y <= y) != (b.y <= y)) {
            double const x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
            include(x, x);
        }
    }
    for (Round const& disc : discs_) {
        double const up = y - disc.centre.y;
        if (std::abs(up) < disc.radius) {
            double const half = std::sqrt(disc.radius * disc.radius - up * up);
            include(disc.centre.x - half, disc.centre.x + half);
        }
    }
    return found;
}

Strips common(Slab const& a, Slab const& b, int count) {
    double const low = std::max(a.heights().from, b.heights().from);
    double const high = std::min(a.heights().to, b.heights().to);
    Strips sum;
    double const step = (high - low) / count;
    for (int i = 0; i < count && high > low; ++i) {
        double const y = low + (i + 0.5) * step;
        auto const inA = a.at(y);
        auto const inB = b.at(y);
        if (!inA || !inB) {
            continue;
        }
        double const from = std::max(inA->from, inB->from);
        double const to = std::min(inA->to, inB->to);
        if (to > from) {
            double const strip = (to - from) * step;
            double const middle = (from + to) / 2;
            sum.area += strip;
            sum.centroid += strip * Vec2{middle, y};
            sum.xx += step * (to * to * to - from * from * from) / 3;
            sum.xy += strip * middle * y;
            sum.yy += strip * y * y;
        }
    }
    if (sum.area > 0) {
        sum.centroid *= 1 / sum.area;
    }
    return sum;
}

} // namespace trembler::test
