#include "physics/dynamics/core/drag.hpp"

#include <algorithm>

namespace trembler {
namespace {

// The part of a load that remains, between zero and the whole load.
double left(double load, double taken) {
    return std::clamp(load + taken, std::min(load, 0.0), std::max(load, 0.0));
}

} // namespace

void Drag::add(Vec2 arm, double axx, double axy, double ayy, double angular) {
    // The point moves with v + ω r', r' the arm turned by a quarter.
    Vec2 const r = perpendicular(arm);
    double const fx = axx * r.x + axy * r.y;
    double const fy = axy * r.x + ayy * r.y;
    xx += axx;
    xy += axy;
    yy += ayy;
    xt += fx;
    yt += fy;
    tt += r.x * fx + r.y * fy + angular;
}

bool isResistance(double xx, double xy, double yy, double angular) {
    constexpr double rounding = 1 + 1e-9;
    return xx >= 0 && yy >= 0 && xy * xy <= rounding * xx * yy && angular >= 0 && xx <= maximumDrag &&
           yy <= maximumDrag && angular <= maximumDrag;
}

Twist dragImpulse(Drag const& drag, double mass, double inertia, Twist const& free, double h) {
    // In units in which every inertia is 1 the matrix is 1 + h D': its Cholesky factors are never near zero.
    double const m = 1 / std::sqrt(mass);
    double const t = 1 / std::sqrt(inertia);
    double const a = 1 + h * m * m * drag.xx;
    double const b = h * m * m * drag.xy;
    double const c = 1 + h * m * m * drag.yy;
    double const d = h * m * t * drag.xt;
    double const e = h * m * t * drag.yt;
    double const f = 1 + h * t * t * drag.tt;
    double const l11 = std::sqrt(a);
    double const l21 = b / l11;
    double const l31 = d / l11;
    double const l22 = std::sqrt(std::fmax(c - l21 * l21, 1));
    double const l32 = (e - l31 * l21) / l22;
    double const l33 = std::sqrt(std::fmax(f - l31 * l31 - l32 * l32, 1));
    Vec2 const p = m * free.linear;
    double const q = t * free.angular;
    double const z1 = p.x / l11;
    double const z2 = (p.y - l21 * z1) / l22;
    double const z3 = (q - l31 * z1 - l32 * z2) / l33;
    double const y3 = z3 / l33;
    double const y2 = (z2 - l32 * y3) / l22;
    double const y1 = (z1 - l21 * y2 - l31 * y3) / l11;
    return {(Vec2{y1, y2} - p) / m, (y3 - q) / t};
}

Twist DraggedBody::before(double mass, double inertia, Twist const& now, Twist const& load, double h) {
    Twist const free{now.linear +
                         Vec2{left(load.linear.x, taken_.linear.x), left(load.linear.y, taken_.linear.y)},
                     now.angular + left(load.angular, taken_.angular)};
    Twist const impulse = dragImpulse(drag, mass, inertia, free, h);
    expected_ = {now.linear + impulse.linear + load.linear, now.angular + impulse.angular + load.angular};
    return impulse;
}

void DraggedBody::after(Twist const& now) {
    taken_ = {now.linear - expected_.linear, now.angular - expected_.angular};
}

} // namespace trembler
