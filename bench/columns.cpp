// Iteration over columns compared with raw arrays: two properties of 16 bytes each, p += v, a million
// objects. Alternating repetitions, medians. Limit: 1.3 times raw arrays if the columns have the same owners.
#include "bench/measure.hpp"
#include "runtime/placement.hpp"
#include "runtime/property/for_each.hpp"

#include <vector>

namespace {

using namespace trembler;

constexpr std::size_t count = 1000000;
constexpr int repetitions = 41;
constexpr double limit = 1.3;

struct Columns {
    Column<Position> positions;
    Column<Velocity> velocities;
};

// Every `step`th object has a velocity.
void fill(Columns& columns, std::uint32_t step) {
    for (std::uint32_t i = 0; i < count; ++i) {
        columns.positions.set({i, 0}, {{1e-3 * i, 0}});
        if (i % step == 0) {
            columns.velocities.set({i, 0}, {{1e-6 * i, 1e-6}});
        }
    }
}

void moveColumns(Columns& columns) {
    forEach([](ObjectId, Position& p, Velocity const& v) { p.value += v.value; }, columns.positions,
            columns.velocities);
}

} // namespace

int main() {
    std::vector<Vec2> rawPositions(count);
    std::vector<Vec2> rawVelocities(count);
    for (std::size_t i = 0; i < count; ++i) {
        rawPositions[i] = {1e-3 * static_cast<double>(i), 0};
        rawVelocities[i] = {1e-6 * static_cast<double>(i), 1e-6};
    }
    Columns aligned;
    fill(aligned, 1);
    Columns half;
    fill(half, 2);

    bench::Series raw;
    bench::Series joined;
    bench::Series firstWalked;
    bench::Series rarestWalked;
    for (int r = 0; r < repetitions; ++r) {
        raw.time([&] {
            Vec2* const p = rawPositions.data();
            Vec2 const* const v = rawVelocities.data();
            for (std::size_t i = 0; i < count; ++i) {
                p[i] += v[i];
            }
            bench::keep(p);
        });
        joined.time([&] {
            moveColumns(aligned);
            bench::keep(aligned.positions.values().data());
        });
        firstWalked.time([&] {
            moveColumns(half);
            bench::keep(half.positions.values().data());
        });
        rarestWalked.time([&] {
            forEach([](ObjectId, Velocity const& v, Position& p) { p.value += v.value; }, half.velocities,
                    half.positions);
            bench::keep(half.positions.values().data());
        });
    }
    bench::Table table("p += v, 1,000,000 objects, 1 thread");
    double const base = raw.median() / count;
    table.row("raw arrays", 1e9 * base, "ns per object");
    table.row("columns, same owners", 1e9 * joined.median() / count, "ns per object",
              joined.median() / raw.median(), limit);
    table.row("columns, half have both, every object walked", 1e9 * firstWalked.median() / count,
              "ns per object");
    table.row("columns, half have both, the rarest walked", 1e9 * rarestWalked.median() / (count / 2.0),
              "ns per match");
    table.print();
    return 0;
}
