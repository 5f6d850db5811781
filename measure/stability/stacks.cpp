// Stacks and pyramids of boxes, with and without weights on top.
#include "measure/stability/hard_case.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trembler::stability {
namespace {

constexpr double anyDrift = std::numeric_limits<double>::infinity();

// Boxes of 1 m and 100 kg, the top one `weight` times as heavy. Drift is measured sideways: Box2D keeps
// shapes 4 mm apart, which lifts a tall stack by centimetres in its first moments.
std::vector<Figure> stack(Setting const& setting, std::uint64_t seed, int boxes, double weight,
                          double allowed) {
    Rig rig(setting, seed);
    rig.fixed(boxPiece(40, 1), {0, -0.5});
    for (int i = 0; i < boxes; ++i) {
        rig.body(boxPiece(1, 1), {0.002 * rig.jitter(), 0.5 + i}, i + 1 == boxes ? 100 * weight : 100);
    }
    double drift = 0;
    double lost = 0;
    for (int frame = 0; frame < 20 * second && lost < 1; ++frame) {
        rig.step();
        drift = std::max(drift, orWorst(rig.sidewaysDrift()));
        lost = orWorst(boxes - 0.5 - rig.at(rig.bodies().back()).y);
    }
    return {{"height lost", "m", 0.5, lost}, {"drift", "m", allowed, drift}};
}

std::vector<Figure> pyramid(Setting const& setting, std::uint64_t seed) {
    Rig rig(setting, seed);
    rig.fixed(boxPiece(60, 1), {0, -0.5});
    for (int row = 0; row < 20; ++row) {
        for (int i = 0; i < 20 - row; ++i) {
            rig.body(boxPiece(1, 1), {1.1 * (i - 0.5 * (19 - row)) + 0.005 * rig.jitter(), 0.5 + row}, 100);
        }
    }
    double drift = 0;
    for (int frame = 0; frame < 20 * second; ++frame) {
        rig.step();
        drift = std::max(drift, orWorst(rig.drift()));
    }
    return {{"drift", "m", 0.3, drift}};
}

// A box a hundred times as heavy falls on the top from 2 m. The height of the rest is that of the highest of
// the small boxes.
std::vector<Figure> hitPyramid(Setting const& setting, std::uint64_t seed) {
    Rig rig(setting, seed);
    rig.fixed(boxPiece(60, 1), {0, -0.5});
    for (int row = 0; row < 10; ++row) {
        for (int i = 0; i < 10 - row; ++i) {
            rig.body(boxPiece(1, 1), {1.01 * (i - 0.5 * (9 - row)) + 0.005 * rig.jitter(), 0.5 + row}, 100);
        }
    }
    auto const small = rig.bodies();
    rig.body(boxPiece(1, 1), {0.005 * rig.jitter(), 12.5}, 10000);
    for (int frame = 0; frame < 20 * second; ++frame) {
        rig.step();
    }
    double height = 0;
    for (ObjectId const id : small) {
        height = std::max(height, rig.at(id).y);
    }
    return {{"height lost", "m", 1, orWorst(9.5 - height)}};
}

} // namespace

std::vector<HardCase> stackCases() {
    std::vector<HardCase> cases;
    for (int const boxes : {12, 20, 50}) {
        cases.push_back({"stack of boxes", fmt::format("{} boxes", boxes),
                         [=](Setting const& setting, std::uint64_t seed) {
                             return stack(setting, seed, boxes, 1, 0.05);
                         }});
    }
    for (int const weight : {100, 1000}) {
        cases.push_back({fmt::format("10 boxes under 1:{}", weight), "",
                         [=](Setting const& setting, std::uint64_t seed) {
                             return stack(setting, seed, 11, weight, anyDrift);
                         },
                         true, weight == 100});
    }
    cases.push_back({"pyramid, base 20", "", pyramid, true, false});
    cases.push_back({"pyramid, base 10, a 100:1 top dropped from 2 m", "", hitPyramid, true, false});
    return cases;
}

} // namespace trembler::stability
