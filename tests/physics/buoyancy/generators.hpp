// Random shapes for tests of buoyancy.
#pragma once

#include "physics/dynamics/properties/shape.hpp"

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

namespace trembler::test {

/// A number from `low` to `high` in steps of a 10000th, independent of the size of the test case.
inline rc::Gen<double> number(double low, double high) {
    return rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 10001)),
                        [=](int n) { return low + (high - low) * n / 10000; });
}

inline rc::Gen<Vec2> point(double reach) {
    return rc::gen::map(rc::gen::pair(number(-reach, reach), number(-reach, reach)),
                        [](std::pair<double, double> const& p) {
                            return Vec2{p.first, p.second};
                        });
}

/// Three to eight corners on an ellipse, anticlockwise, with a least distance between them.
inline rc::Gen<ShapePiece> convexPolygon() {
    return rc::gen::exec([] {
        int const count = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(3, 9));
        double const a = *number(0.05, 1);
        double const b = *number(0.05, 1);
        std::vector<Vec2> corners;
        for (int i = 0; i < count; ++i) {
            double const angle = 2 * pi * (i + *number(0.1, 0.9)) / count;
            corners.push_back({a * std::cos(angle), b * std::sin(angle)});
        }
        return polygonPiece(corners, *point(0.5), *number(-3, 3));
    });
}

inline rc::Gen<ShapePiece> piece() {
    return rc::gen::exec([] {
        switch (*rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 4))) {
        case 0:
            return circlePiece(*number(0.05, 1), *point(0.5));
        case 1:
            return boxPiece(*number(0.02, 2), *number(0.02, 2), *point(0.5), *number(-3, 3));
        case 2: {
            double const radius = *number(0.02, 0.5);
            return capsulePiece(2 * radius + *number(0, 2), radius, *point(0.5), *number(-3, 3));
        }
        default:
            return *convexPolygon();
        }
    });
}

} // namespace trembler::test
