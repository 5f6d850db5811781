// How far off forces are, found out by computing them again for a few objects.
#pragma once

#include "game/budget/knob.hpp"
#include "physics/inverse_square/points.hpp"
#include "runtime/world/world.hpp"

#include <functional>
#include <map>
#include <span>
#include <vector>

namespace trembler::budget {

/// A few objects that forces can move: that have a mass and are not fixed.
struct Sample {
    struct Body {
        ObjectId object;
        double mass = 0; ///< kg
    };
    std::vector<Body> bodies; ///< ascending

    /// Where an object stands in it, or -1.
    [[nodiscard]] int find(std::uint32_t index) const;
};

inline constexpr std::size_t sampleSize = 16;

/// At most sampleSize of the objects for which `counts` says yes, evenly spread over their ids.
[[nodiscard]] Sample sampleOf(World const& world, std::function<bool(ObjectId)> const& counts);

/// Of forces (N, one per body of the sample) against right ones. A force that is off by dF takes a body of
/// the mass m off course by ½ dF/m · (1 s)² within the first second; but what is held by something that
/// yields with `stiffness` (N/m, one per body; 0: nothing does), as the water holds what floats, by no more
/// than dF/stiffness.
[[nodiscard]] Error errorOf(Sample const& sample, std::span<Vec2 const> forces, std::span<Vec2 const> right,
                            std::span<double const> stiffness = {});

/// One inverse-square sum of an effect: what acts, and on what of the sample.
struct SampledSum {
    inverse_square::Points sources;
    inverse_square::Points receivers; ///< those that belong to the sample
    double softening2 = 0;            ///< m²

    /// Leaves those of all receivers whose owners are in the sample.
    void receive(inverse_square::Points const& all, Sample const& sample);
    /// Moves everything on by its velocity times `seconds`.
    void moveOn(World const& world, double seconds);
};

/// Adds to totals what the sources do to each receiver.
using AddUp = std::function<void(SampledSum const&, std::span<Vec2> totals)>;

/// N for each body of the sample, of all sums together.
[[nodiscard]] std::vector<Vec2> forcesOn(Sample const& sample, std::span<SampledSum const> sums,
                                         AddUp const& addUp);

void addPairs(SampledSum const& sum, std::span<Vec2> totals);
/// Cut off smoothly between `inner` and `cutoff` (m).
[[nodiscard]] AddUp byGrid(double inner, double cutoff);

/// How far off forces are that stand for so many frames while everything moves on: on average they are
/// (period - 1) / 2 frames old. Each period is looked into once.
class Staleness {
public:
    /// All must outlive it; `right` are the forces as of now.
    Staleness(World const& world, Sample const& sample, std::span<SampledSum const> sums,
              std::span<Vec2 const> right)
        : world_(world), sample_(sample), sums_(sums), right_(right) {}
    [[nodiscard]] Error of(int period);

private:
    World const& world_;
    Sample const& sample_;
    std::span<SampledSum const> sums_;
    std::span<Vec2 const> right_;
    std::map<int, Error> known_;
};

} // namespace trembler::budget
