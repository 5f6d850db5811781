#include "render/scene/objects/joint_parts.hpp"

#include "render/draw/path.hpp"
#include "render/scene/marks/dashes.hpp"
#include "render/scene/objects/ties.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace trembler::render {
namespace {

constexpr double pulleyRadius = 0.12; // m

Style metal(Colour tint, float height) {
    return {.pattern = Pattern::Metal, .tint = tint, .outline = 1.3F, .height = height};
}

void drawPin(Canvas& canvas, Point at, double angle, double radius = pinRadius) {
    canvas.circle({at, angle}, radius, metal(mix(palette::steel, palette::ink, 0.25F), 0.4F));
    canvas.circle({at, angle}, 0.4 * radius, metal(mix(palette::steel, palette::ink, 0.7F), 0.F));
}

// The sign of a pin that is held by the world itself: a stand with the ground's hatching under it.
void drawStand(Canvas& canvas, Point at) {
    double const size = 2.1 * pinRadius;
    std::array const stand{Point{0, 0}, Point{-size, -1.7 * size}, Point{size, -1.7 * size}};
    canvas.polygon({at, 0}, stand, {.tint = palette::paperLight, .outline = 1.5F, .height = 0.3F});
    Stroke const stroke{.colour = palette::ink, .pixels = 1.5F};
    Point const left = at + Point{-1.4 * size, -1.7 * size};
    Point const right = at + Point{1.4 * size, -1.7 * size};
    canvas.line(left, right, stroke);
    for (int i = 0; i < 5; ++i) {
        Point const from = left + (i + 0.6) / 5 * (right - left);
        canvas.line(from, from + Point{-0.5 * size, -0.5 * size}, {.colour = palette::ink, .pixels = 1.1F});
    }
}

void drawMotor(Canvas& canvas, Joint const& joint, Point at) {
    if (!joint.motor) {
        return;
    }
    double const radius = 2.2 * pinRadius;
    double const way = joint.motorSpeed < 0 ? -1 : 1;
    Stroke const stroke{.colour = palette::accent, .pixels = 2.4F};
    double const start = 0.25 * std::numbers::pi;
    double const sweep = way * 1.4 * std::numbers::pi;
    canvas.arc(at, radius, start, sweep, stroke);
    double const end = start + sweep;
    Point const tip = at + radius * Point{std::cos(end), std::sin(end)};
    Point const along = way * Point{-std::sin(end), std::cos(end)};
    canvas.arrow(tip - 0.2 * radius * along, tip + 0.8 * radius * along, stroke);
}

void drawRail(Canvas& canvas, Joint const& joint, JointPlaces const& places) {
    // The rail belongs to b: it starts where the joint was made, which is where b holds it.
    double const from = joint.limited ? joint.lower : -0.6;
    double const to = joint.limited ? joint.upper : 0.6;
    Point const start = places.b + from * places.axis;
    Point const end = places.b + to * places.axis;
    Point const across = 0.06 * Point{-places.axis.y, places.axis.x};
    Stroke const bar{.colour = mix(palette::steel, palette::ink, 0.3F),
                     .width = 0.02,
                     .pixels = 1.6F,
                     .outline = 1.F,
                     .height = 0.4F};
    canvas.line(start + across, end + across, bar);
    canvas.line(start - across, end - across, bar);
    if (joint.limited) {
        for (Point const stop : {start, end}) {
            canvas.line(stop - 1.7 * across, stop + 1.7 * across, bar);
        }
    }
    canvas.box({places.a, std::atan2(places.axis.y, places.axis.x)}, {0.08, 0.045}, 0.015,
               metal(palette::steel, 0.5F));
}

// The rope, rod or spring between the joint's two ends.
JointDrawn tieOf(Joint const& joint) {
    if (joint.look.drawn != JointDrawn::own) {
        return joint.look.drawn;
    }
    switch (joint.form) {
    case JointForm::distance:
        return JointDrawn::rod;
    case JointForm::spring:
        return JointDrawn::spring;
    default:
        return JointDrawn::rope;
    }
}

void drawPulley(Canvas& canvas, Joint const& joint, JointPlaces const& places, JointDrawn look) {
    Point const wheelA{joint.groundA.x, joint.groundA.y};
    Point const wheelB{joint.groundB.x, joint.groundB.y};
    // Each end hangs from the outer side of its wheel and runs over the top to the other.
    double const side = wheelA.x < wheelB.x || (wheelA.x == wheelB.x && places.a.x <= places.b.x) ? -1 : 1;
    std::vector<Point> path{places.a};
    for (int i = 0; i <= 6; ++i) {
        double const angle = 0.5 * std::numbers::pi * (1 - i / 6.0);
        path.push_back(wheelA + pulleyRadius * Point{side * std::sin(angle), std::cos(angle)});
    }
    for (int i = 0; i <= 6; ++i) {
        double const angle = 0.5 * std::numbers::pi * i / 6.0;
        path.push_back(wheelB + pulleyRadius * Point{-side * std::sin(angle), std::cos(angle)});
    }
    path.push_back(places.b);
    for (Point const wheel : {wheelA, wheelB}) {
        canvas.circle({wheel, 0}, 0.92 * pulleyRadius, metal(palette::steel, 0.8F));
        drawPin(canvas, wheel, 0, 0.3 * pulleyRadius);
    }
    drawTie(canvas, look, path);
    drawPin(canvas, places.a, places.angleA, 0.7 * pinRadius);
    drawPin(canvas, places.b, places.angleB, 0.7 * pinRadius);
}

} // namespace

void drawJoint(Canvas& canvas, Joint const& joint, JointPlaces const& places) {
    if (joint.look.drawn == JointDrawn::none) {
        return;
    }
    JointDrawn const look = tieOf(joint);
    auto const ends = [&](double size) {
        drawPin(canvas, places.a, places.angleA, size * pinRadius);
        drawPin(canvas, places.b, places.angleB, size * pinRadius);
    };
    switch (joint.form) {
    case JointForm::hinge:
        if (places.toWorld) {
            drawStand(canvas, places.a);
        }
        drawMotor(canvas, joint, places.a);
        drawPin(canvas, places.a, places.angleA);
        break;
    case JointForm::weld: {
        // A bead of weld: a short rough bar.
        Stroke const bead{.colour = mix(palette::steel, palette::ink, 0.5F), .width = 0.05, .outline = 1.F};
        canvas.line(places.a - Point{0.03, 0.03}, places.a + Point{0.03, 0.03}, bead);
        canvas.line(places.a - Point{0.03, -0.03}, places.a + Point{0.03, -0.03}, bead);
        break;
    }
    case JointForm::slider:
        drawRail(canvas, joint, places);
        break;
    case JointForm::distance:
    case JointForm::rope:
        drawTie(canvas, look,
                look == JointDrawn::rod || look == JointDrawn::spring
                    ? std::vector<Point>{places.a, places.b}
                    : ropePath(places.a, places.b, joint.form == JointForm::rope ? places.length : 0));
        ends(0.7);
        break;
    case JointForm::spring:
        if (look == JointDrawn::spring) {
            drawCoil(canvas, places.a, places.b, places.length);
        } else {
            drawTie(canvas, look, std::vector<Point>{places.a, places.b});
        }
        ends(0.7);
        break;
    case JointForm::pulley:
        drawPulley(canvas, joint, places, look);
        break;
    case JointForm::wheel:
        drawMotor(canvas, joint, places.a);
        if (double const travel = length(places.b - places.a); travel > 0.01) {
            canvas.polyline(coil(places.b, places.a, 0.05, 5),
                            {.colour = palette::steel, .width = 0.02, .pixels = 1.6F, .outline = 1.F});
        }
        drawPin(canvas, places.a, places.angleA, 1.2 * pinRadius);
        break;
    case JointForm::gear:
        break;
    }
}

void drawGearPitch(Canvas& canvas, Point pinA, Point pinB, double ratio) {
    double const apart = length(pinB - pinA);
    double const share = std::abs(ratio);
    if (!(apart > 0) || !(share > 0)) {
        return;
    }
    // a + ratio * b stays as it is: where the two meet, radius a * turn a = radius b * turn b.
    double const sum = ratio > 0 ? 1 + share : std::abs(share - 1);
    if (!(sum > 1e-6)) {
        return;
    }
    std::array const circles{std::pair{pinA, apart / sum}, std::pair{pinB, apart * share / sum}};
    for (auto const& [centre, radius] : circles) {
        std::vector<Point> path;
        for (int i = 0; i < 72; ++i) {
            double const angle = 2 * std::numbers::pi * i / 72;
            path.push_back(centre + radius * Point{std::cos(angle), std::sin(angle)});
        }
        dashed(canvas, path, true, canvas.metres(12), canvas.metres(4),
               {.colour = palette::inkSoft, .pixels = 1.5F});
    }
}

} // namespace trembler::render
