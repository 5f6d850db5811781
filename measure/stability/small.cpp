// Small boxes and thin cards: the engine keeps shapes a fixed distance apart, which is a large share of their
// size.
#include "measure/stability/hard_case.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::stability {
namespace {

std::vector<Figure> smallPyramid(Setting const& setting, std::uint64_t seed) {
    constexpr double size = 0.05;
    constexpr int base = 30;
    Rig rig(setting, seed);
    rig.fixed(boxPiece(6, 0.1), {0, -0.05});
    for (int row = 0; row < base; ++row) {
        for (int i = 0; i < base - row; ++i) {
            rig.body(
                boxPiece(size, size),
                {1.1 * size * (i - 0.5 * (base - 1 - row)) + 0.005 * size * rig.jitter(), size * (0.5 + row)},
                0.25);
        }
    }
    double drift = 0;
    for (int frame = 0; frame < 10 * second; ++frame) {
        rig.step();
        drift = std::max(drift, orWorst(rig.drift()));
    }
    return {{"drift", "m", 0.1, drift}};
}

// Cards of 0.2 m and 1 cm thickness lean against each other in pairs at 70 degrees; others lie across. The
// house stands if no card has sunk by half a storey.
std::vector<Figure> cardHouse(Setting const& setting, std::uint64_t seed) {
    constexpr double card = 0.2;
    constexpr double thick = 0.01;
    constexpr double steep = 1.2217; // 70 degrees
    constexpr int levels = 5;
    double const rise = card * std::sin(steep) + thick * std::cos(steep);
    double const foot = card * std::cos(steep) + thick * std::sin(steep); // width of a leaning card
    double const level = rise + thick;
    double const tent = 2 * foot + 0.002;
    Rig rig(setting, seed);
    rig.fixed(boxPiece(6, 0.1), {0, -0.05});
    std::vector<double> heights;
    auto const add = [&](double width, Vec2 at, double angle) {
        ObjectId const id = rig.body(boxPiece(width, thick), at + 1e-4 * Vec2{rig.jitter(), 0}, 0.2, angle);
        rig.give(id, Friction{0.8});
        heights.push_back(at.y);
    };
    for (int row = 0; row < levels; ++row) {
        int const tents = levels - row;
        for (int i = 0; i < tents; ++i) {
            double const x = tent * (i - 0.5 * (tents - 1));
            double const y = level * row + rise / 2;
            add(card, {x - foot / 2, y}, steep);
            add(card, {x + foot / 2, y}, pi - steep);
        }
        for (int i = 0; i + 1 < tents; ++i) {
            add(tent - 0.001, {tent * (i - 0.5 * (tents - 2)), level * row + rise + thick / 2}, 0);
        }
    }
    double sunk = 0;
    for (int frame = 0; frame < 10 * second; ++frame) {
        rig.step();
        for (std::size_t i = 0; i < heights.size(); ++i) {
            sunk = std::max(sunk, orWorst(heights[i] - rig.at(rig.bodies()[i]).y));
        }
    }
    return {{"height lost by any card", "m", level / 2, sunk}};
}

} // namespace

std::vector<HardCase> smallCases() {
    return {{"pyramid of 5 cm boxes, base 30", "", smallPyramid, true, false},
            {"card house of 5 levels", "", cardHouse}};
}

} // namespace trembler::stability
