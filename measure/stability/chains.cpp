// Chains under heavy balls, bridges and cantilevers.
#include "measure/stability/hard_case.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trembler::stability {
namespace {

// Angles of the links of the right half, from the middle outwards, of a chain at rest whose ends are `span`
// apart: the horizontal force H is the same in every link, and each carries half of the ball and of the
// weight below it, so tan(angle) = V / H. H is found by bisection.
std::vector<double> restAngles(int half, double link, double linkMass, double ballMass, double span) {
    std::vector<double> angles(static_cast<std::size_t>(half));
    double low = 1e-6 * g * linkMass;
    double high = 1e6 * g * (ballMass + linkMass * half);
    for (int i = 0; i < 200; ++i) {
        double const pull = std::sqrt(low * high);
        double width = 0;
        for (int k = 0; k < half; ++k) {
            double const below = (ballMass / 2 + linkMass * (k + 0.5)) * g;
            angles[static_cast<std::size_t>(k)] = std::atan2(below, pull);
            width += link * std::cos(angles[static_cast<std::size_t>(k)]);
        }
        (2 * width < span ? low : high) = pull;
    }
    return angles;
}

// The chain starts at rest between two pins that are 0.8 of its length apart, except for the jitter: so joint
// gaps and speeds come from the engine alone.
std::vector<Figure> chain(Setting const& setting, std::uint64_t seed, int links, double ratio) {
    constexpr double link = 0.2;
    Rig rig(setting, seed);
    std::vector<double> const angles = restAngles(links / 2, link, 1, ratio, 0.8 * link * links);
    Vec2 depth;
    for (double const angle : angles) {
        depth += link * Vec2{std::cos(angle), std::sin(angle)};
    }
    Vec2 pin = -depth; // so that the ball is at the origin
    pin.y = depth.y;
    ObjectId before;
    for (int i = 0; i < links; ++i) {
        double const angle = i < links / 2 ? -angles[static_cast<std::size_t>(links / 2 - 1 - i)]
                                           : angles[static_cast<std::size_t>(i - links / 2)];
        Vec2 const next = pin + link * Vec2{std::cos(angle), std::sin(angle)};
        ObjectId const id =
            rig.body(boxPiece(link, 0.05), 0.5 * (pin + next), 1 + 0.02 * rig.jitter(), angle);
        rig.give(id, Velocity{0.02 * Vec2{rig.jitter(), rig.jitter()}});
        rig.give(id, CollisionGroups{.category = 1, .mask = 0xffff, .group = -1});
        rig.tie(JointForm::hinge, id, before, pin);
        before = id;
        pin = next;
        if (i + 1 == links / 2) {
            ObjectId const ball = rig.body(circlePiece(0.2), next, ratio);
            rig.give(ball, CollisionGroups{.category = 1, .mask = 0xffff, .group = -1});
            rig.tie(JointForm::hinge, ball, id, next);
        }
    }
    rig.tie(JointForm::hinge, before, {}, pin);
    double gap = 0;
    double jitter = 0;
    for (int frame = 1; frame <= 10 * second; ++frame) {
        rig.step();
        gap = std::max(gap, orWorst(rig.worstGap()));
        if (frame > 9 * second) {
            jitter = std::max(jitter, orWorst(rig.fastest()));
        }
    }
    return {{"joint gap", "m", 0.02, gap}, {"jitter in the last second", "m/s", 0.2, jitter}};
}

// Planks on a flat arc 2 % longer than its span, released.
std::vector<Figure> bridge(Setting const& setting, std::uint64_t seed) {
    constexpr int planks = 160;
    constexpr double plank = 0.5;
    constexpr double halfAngle = 0.347; // sin(a) / a = 0.98
    double const radius = plank / (2 * std::sin(halfAngle / planks));
    auto const knot = [&](int i) {
        double const a = halfAngle * (2.0 * i / planks - 1);
        return Vec2{radius * std::sin(a), -radius * std::cos(a)};
    };
    Rig rig(setting, seed);
    ObjectId before;
    for (int i = 0; i < planks; ++i) {
        Vec2 const along = knot(i + 1) - knot(i);
        ObjectId const id = rig.body(boxPiece(plank, 0.1), 0.5 * (knot(i) + knot(i + 1)),
                                     5 + 0.1 * rig.jitter(), std::atan2(along.y, along.x));
        rig.give(id, CollisionGroups{.category = 1, .mask = 0xffff, .group = -1});
        rig.tie(JointForm::hinge, id, before, knot(i));
        before = id;
    }
    rig.tie(JointForm::hinge, before, {}, knot(planks));
    double gap = 0;
    for (int frame = 0; frame < 10 * second; ++frame) {
        rig.step();
        gap = std::max(gap, orWorst(rig.worstGap()));
    }
    return {{"joint gap", "m", 0.05, gap}};
}

std::vector<Figure> cantilever(Setting const& setting, std::uint64_t seed) {
    constexpr double plank = 0.5;
    Rig rig(setting, seed);
    ObjectId before;
    for (int i = 0; i < 8; ++i) {
        ObjectId const id = rig.body(boxPiece(plank, 0.125), {plank * (i + 0.5), 0}, 5 + 0.1 * rig.jitter());
        rig.tie(JointForm::weld, id, before, {plank * i, 0});
        before = id;
    }
    double const before0 = rig.at(before).y;
    double sag = 0;
    double gap = 0;
    for (int frame = 0; frame < 10 * second; ++frame) {
        rig.step();
        double const angle = rig.angle(before);
        sag = std::max(sag, orWorst(before0 - (rig.at(before).y + plank / 2 * std::sin(angle))));
        gap = std::max(gap, orWorst(rig.worstGap()));
    }
    return {{"tip sag", "m", 0.2, sag}, {"joint gap", "m", 0.05, gap}};
}

} // namespace

std::vector<HardCase> chainCases() {
    std::vector<HardCase> cases;
    for (int const links : {30, 100, 200}) {
        for (int const ratio : {1, 10, 100, 1000}) {
            cases.push_back({"suspended chain, ball at the middle",
                             fmt::format("{} links, 1:{}", links, ratio),
                             [=](Setting const& setting, std::uint64_t seed) {
                                 return chain(setting, seed, links, ratio);
                             },
                             true, links < 200 || ratio == 1000});
        }
    }
    cases.push_back({"bridge of 160 planks", "", bridge});
    cases.push_back({"cantilever of 8 welds", "", cantilever});
    return cases;
}

} // namespace trembler::stability
