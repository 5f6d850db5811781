// The gain from trees and grids for very many bodies that attract one another: time per frame and error of
// the detail levels of gravity and magnetism by number of bodies, and the number at which they overtake the
// sum over all pairs.
//
//     bench_many_bodies
//
// Prints Markdown. Errors are the same on every machine; times are medians of single frames on one thread.
#include "bench/measure.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/standstill.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/gravity/register.hpp"
#include "physics/inverse_square/kernels.hpp"
#include "physics/magnetism/properties.hpp"
#include "physics/magnetism/register.hpp"
#include "runtime/placement.hpp"
#include "runtime/population/population_resolver.hpp"
#include "runtime/world/world.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace {

using namespace trembler;

constexpr std::array<int, 8> counts{100, 300, 500, 1000, 2000, 4000, 10000, 30000};
constexpr std::array<double, 4> angles{0.25, 0.35, 0.5, 0.7};
constexpr double spacing = 0.5; // m, mean distance of neighbours

struct Result {
    double microseconds = 0;
    std::vector<Vec2> forces;
};

Vec2 placeOf(int i) { // a sunflower spiral: uniform density without a lattice
    double const radius = spacing * std::sqrt(static_cast<double>(i));
    double const angle = i * pi * (3 - std::sqrt(5.0));
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

void placeMasses(Store& store, int count, double angle) {
    store.column<GravityLaw>().set(store.create("law"), {1, 0.1, angle});
    for (int i = 0; i < count; ++i) {
        ObjectId const id = store.create("m" + std::to_string(i));
        store.column<Position>().set(id, {placeOf(i)});
        store.column<Mass>().set(id, {1.0 + i % 5});
    }
}

void placeMagnets(Store& store, int count, double angle, bool oneSign) {
    MagnetismSettings settings;
    settings.openingAngle = angle;
    settings.cutoff = 4;
    store.column<MagnetismSettings>().set(store.create("settings"), settings);
    for (int i = 0; i < count; ++i) {
        ObjectId const id = store.create("m" + std::to_string(i));
        store.column<Position>().set(id, {placeOf(i)});
        store.column<Rotation>().set(id, {1.7 * i});
        store.column<MagneticStrength>().set(id, {100.0 + i % 50, 0});
        store.column<MagneticPoles>().set(id,
                                          {oneSign ? PoleSet::north : PoleSet::both, {0.1, 0}, {-0.1, 0}});
    }
}

template <class Force>
Result measure(Registry const& registry, std::string const& effect, std::string const& level,
               auto const& place, int repetitions) {
    World world(registry, {.threads = 1, .detail = {{effect, level}}, .periods = {}});
    place(world.store());
    world.start();
    bench::Series series;
    ObjectId const first = world.store().find("m0");
    for (int i = 0; i <= repetitions; ++i) {
        // Marks the column as changed, which wakes the component.
        world.store().column<Position>().set(first, {placeOf(0)});
        world.step();
        for (ComponentStatus const& status : world.status()) {
            if (i > 0 && status.info->text.effect == effect && status.info->text.level == level) {
                series.add(status.lastMicroseconds);
            }
        }
    }
    Result result{series.median(), {}};
    for (auto const& entry : world.find<Force>()->forces) {
        result.forces.push_back(entry.force);
    }
    return result;
}

double error(Result const& result, Result const& exact) {
    double wrong = 0;
    double all = 0;
    for (std::size_t i = 0; i < exact.forces.size(); ++i) {
        wrong += lengthSquared(result.forces[i] - exact.forces[i]);
        all += lengthSquared(exact.forces[i]);
    }
    return std::sqrt(wrong / all);
}

int repetitionsFor(int count) {
    return count > 10000 ? 3 : count > 1000 ? 9 : 31;
}

void kernelsTable() {
    fmt::print("**one pair, by vector width (ns)**\n\n| kernel | numbers at a time | pairs | cut off | "
               "clusters |\n|---|---|---|---|---|\n");
    namespace isq = inverse_square;
    isq::Points points;
    std::vector<isq::Cluster> clusters;
    for (int i = 0; i < 2000; ++i) {
        points.add(placeOf(i), 1, i);
        clusters.push_back({placeOf(i).x, placeOf(i).y, 1, 0.1, 0.1, 0.1, 0.1, 0.1});
    }
    std::vector<Vec2> const none(points.size());
    for (isq::Kernels const& kernels : isq::availableKernels()) {
        std::array<bench::Series, 3> series;
        for (int i = 0; i < 400; ++i) {
            isq::Block block;
            auto const row = [i](std::size_t k) { return static_cast<std::size_t>(i) + k; };
            isq::fillBlock(block, points, none, isq::blockSize, row, row);
            series[0].time([&] { kernels.addPairs(points, 0, points.size(), 0.01, block); });
            series[1].time(
                [&] { kernels.addWindowed(points, 0, points.size(), 0.01, isq::Window(8, 10), block); });
            series[2].time([&] { kernels.addClusters(clusters, 0.01, block); });
            bench::keep(block);
        }
        double const each = 1e9 / (2000.0 * isq::blockSize);
        fmt::print("| {} | {} | {:.2f} | {:.2f} | {:.2f} |\n", kernels.name, kernels.width,
                   each * series[0].median(), each * series[1].median(), each * series[2].median());
    }
    fmt::print("\n");
}

void gravityTable(Registry const& registry) {
    fmt::print("**gravity: µs per frame (relative error of the forces)**\n\n| masses | real |");
    for (double const angle : angles) {
        fmt::print(" tree, angle {} |", angle);
    }
    fmt::print("\n|---|---|---|---|---|---|\n");
    for (int const count : counts) {
        int const repetitions = repetitionsFor(count);
        auto const run = [&](std::string const& level, double angle) {
            return measure<GravityForce>(
                registry, "gravity", level, [&](Store& s) { placeMasses(s, count, angle); }, repetitions);
        };
        Result const exact = run("real", 0);
        fmt::print("| {} | {:.0f} |", count, exact.microseconds);
        for (double const angle : angles) {
            Result const tree = run("tree", angle);
            fmt::print(" {:.0f} ({:.1e}) |", tree.microseconds, error(tree, exact));
        }
        fmt::print("\n");
    }
    fmt::print("\n");
}

void magnetismTable(Registry const& registry, bool oneSign) {
    fmt::print("**magnetism, {}: µs per frame (relative error of the forces)**\n\n| magnets | pairwise | "
               "grid, cutoff 4 m |",
               oneSign ? "single north poles" : "bars of 0.2 m");
    for (double const angle : angles) {
        fmt::print(" tree, angle {} |", angle);
    }
    fmt::print("\n|---|---|---|---|---|---|---|\n");
    for (int const count : counts) {
        int const repetitions = repetitionsFor(count);
        auto const run = [&](std::string const& level, double angle) {
            return measure<MagneticForce>(
                registry, "magnetism", level, [&](Store& s) { placeMagnets(s, count, angle, oneSign); },
                repetitions);
        };
        Result const exact = run("pairwise", 0);
        Result const grid = run("grid", 0);
        fmt::print("| {} | {:.0f} | {:.0f} ({:.1e}) |", count, exact.microseconds, grid.microseconds,
                   error(grid, exact));
        for (double const angle : angles) {
            Result const tree = run("tree", angle);
            fmt::print(" {:.0f} ({:.1e}) |", tree.microseconds, error(tree, exact));
        }
        fmt::print("\n");
    }
    fmt::print("\n");
}

} // namespace

int main() {
    Registry gravity;
    registerRuntime(gravity);
    registerGravity(gravity);
    Registry magnetism;
    registerRuntime(magnetism);
    registerMagnetism(magnetism);
    magnetism.component<Standstill>();
    kernelsTable();
    gravityTable(gravity);
    magnetismTable(magnetism, true);
    magnetismTable(magnetism, false);
    return 0;
}
