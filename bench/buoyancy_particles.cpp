// Accuracy by number of particles: area and centroid of the submerged part of Experiment IV's float computed
// with particles (6.11), compared with the exact ones, and the cost of both.
//
//     bench_buoyancy_particles
//
// Prints Markdown. Errors are the same on every machine; times, medians interleaved, are not.
#include "bench/measure.hpp"
#include "physics/buoyancy/hulls/exact_hull.hpp"
#include "physics/buoyancy/hulls/particle_hull.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace {

using namespace trembler;

constexpr double width = 0.6;  // m, the float
constexpr double height = 0.4; // m
constexpr std::array<int, 7> counts{4, 8, 16, 32, 64, 128, 256};
constexpr int angles = 90;
constexpr int depths = 41;
constexpr std::size_t repetitions = 31;

/// The surfaces that cut the float: all attitudes over half a turn, from nearly dry to nearly submerged.
std::vector<Side> surfaces() {
    std::vector<Side> all;
    for (int i = 0; i < angles; ++i) {
        double const angle = std::numbers::pi * i / angles;
        Vec2 const normal{std::cos(angle), std::sin(angle)};
        double const reach = (width * std::abs(normal.x) + height * std::abs(normal.y)) / 2;
        for (int k = 1; k < depths; ++k) {
            all.push_back({normal, reach * (2.0 * k / depths - 1)});
        }
    }
    return all;
}

Displacement cut(Hull const& hull, Side const& surface) {
    return hull.displaced(std::span(&surface, 1), surface.normal);
}

void timeAll(bench::Series& series, Hull const& hull, std::vector<Side> const& all) {
    series.time([&] {
        for (Side const& surface : all) {
            bench::keep(cut(hull, surface));
        }
    });
}

} // namespace

int main() {
    Shape const shape{{boxPiece(width, height)}};
    std::vector<Side> const all = surfaces();
    auto const each = 1e9 / static_cast<double>(all.size()); // converts s per sweep to ns per cut
    ExactHull const exact(shape);
    std::vector<std::unique_ptr<ParticleHull>> hulls;
    for (int const count : counts) {
        hulls.push_back(std::make_unique<ParticleHull>(shape, count));
    }
    bench::Series exactTime;
    std::array<bench::Series, counts.size()> times;
    for (std::size_t i = 0; i < repetitions; ++i) {
        timeAll(exactTime, exact, all);
        for (std::size_t k = 0; k < counts.size(); ++k) {
            timeAll(times[k], *hulls[k], all);
        }
    }
    fmt::print("| particles | area: mean error | worst | centre of buoyancy: mean error (mm) | worst | ns |\n"
               "|---|---|---|---|---|---|\n");
    for (std::size_t k = 0; k < counts.size(); ++k) {
        double area = 0;
        double worstArea = 0;
        double centre = 0;
        double worstCentre = 0;
        for (Side const& surface : all) {
            AreaMoments const want = cut(exact, surface).wet;
            AreaMoments const have = cut(*hulls[k], surface).wet;
            double const error = std::abs(have.area - want.area) / (width * height);
            // Moments over the whole area, so that errors of the centroid count as much as errors of the
            // force.
            double const off =
                std::hypot(have.first.x - want.first.x, have.first.y - want.first.y) / (width * height);
            area += error, centre += off;
            worstArea = std::max(worstArea, error);
            worstCentre = std::max(worstCentre, off);
        }
        auto const n = static_cast<double>(all.size());
        fmt::print("| {} | {:.2f} % | {:.2f} % | {:.2f} | {:.2f} | {:.0f} |\n", hulls[k]->particles().size(),
                   100 * area / n, 100 * worstArea, 1000 * centre / n, 1000 * worstCentre,
                   times[k].median() * each);
    }
    fmt::print("| exact | 0 | 0 | 0 | 0 | {:.0f} |\n", exactTime.median() * each);
    return 0;
}
