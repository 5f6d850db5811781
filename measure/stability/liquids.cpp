// Bodies that float, sink or turn over: densities over six orders of magnitude, plates of a millimetre, hulls
// released upside down.
#include "measure/stability/hard_case.hpp"
#include "physics/buoyancy/properties/liquid.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::stability {
namespace {

// Water with its surface at y = 0, and a floor under it.
void pool(Rig& rig) {
    ObjectId const water = rig.fixed(boxPiece(120, 12), {0, -6});
    rig.world->store().column<Fixed>().remove(water);
    rig.give(water, Density{1000});
    rig.give(water, Liquid{});
    rig.fixed(boxPiece(120, 1), {0, -12.5});
}

std::vector<Figure> settles(Rig& rig, int seconds) {
    double highest = 0;
    for (int frame = 0; frame < seconds * second; ++frame) {
        rig.step();
        for (ObjectId const id : rig.bodies()) {
            highest = std::max(highest, orWorst(std::abs(rig.at(id).y)));
        }
    }
    double spin = 0;
    for (ObjectId const id : rig.bodies()) {
        spin = std::max(spin, orWorst(std::abs(rig.world->find<AngularVelocity>(id)->value)));
    }
    return {{"speed when settled", "m/s", 0.05, orWorst(rig.fastest())},
            {"turning when settled", "rad/s", 0.05, spin},
            {"farthest from the surface", "m", 20, highest},
            {"not finite", "", 0, rig.finite() ? 0.0 : 1.0}};
}

// Thirteen densities from a thousandth to a thousand times the water's, released 3 m deep. Worlds are 0.1 m
// thick: a mass is density times area times 0.1 m.
std::vector<Figure> densities(Setting const& setting, std::uint64_t seed) {
    Rig rig(setting, seed);
    pool(rig);
    int column = 0;
    for (int exponent = -6; exponent <= 6; ++exponent) {
        double const density = 1000 * std::pow(10, exponent / 2.0);
        for (ShapePiece const& piece : {boxPiece(0.5, 0.2), circlePiece(0.2)}) {
            rig.body(piece, {-45 + 3.5 * column + 0.2 * rig.jitter(), -3}, density * areaOf(piece) * 0.1,
                     rig.jitter());
            ++column;
        }
    }
    return settles(rig, 60);
}

std::vector<Figure> plates(Setting const& setting, std::uint64_t seed) {
    Rig rig(setting, seed);
    pool(rig);
    int column = 0;
    for (double const thick : {0.02, 0.01, 0.005}) {
        for (double const ratio : {0.1, 0.5, 0.9, 2.0}) {
            rig.body(boxPiece(0.8, thick), {-30 + 5.0 * column + 0.2 * rig.jitter(), 0.5},
                     1000 * ratio * 0.8 * thick * 0.1, pi / 2 * rig.jitter());
            ++column;
        }
    }
    return settles(rig, 60);
}

// Boxes twice as high as wide stand on end, and hulls start upside down, with the mast in the water: both
// turn over.
std::vector<Figure> flipping(Setting const& setting, std::uint64_t seed) {
    Rig rig(setting, seed);
    pool(rig);
    for (int i = 0; i < 4; ++i) {
        rig.body(boxPiece(0.3, 0.6), {-20 + 5.0 * i, 0.1}, 1000 * 0.5 * 0.18 * 0.1, 0.02 * rig.jitter());
        // A hull; its mast, a tenth of its width, points down into the water.
        ObjectId const hull =
            rig.body(boxPiece(1, 0.3), {2 + 5.0 * i, 0.1}, 1000 * 0.4 * 0.3 * 0.1, 0.02 * rig.jitter());
        ShapePiece mast = boxPiece(0.1, 1);
        mast.at = {0, -0.65};
        rig.give(hull, Shape{{boxPiece(1, 0.3), mast}});
    }
    return settles(rig, 120);
}

} // namespace

std::vector<HardCase> liquidCases() {
    return {{"buoyancy at densities 1e-3 to 1e3", "", densities, true, false},
            {"thin plates in water", "", plates, true, false},
            {"flipping hulls", "", flipping, true, false}};
}

} // namespace trembler::stability
