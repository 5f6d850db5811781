// Estimates the error of forces by computing them again for a sample of objects.
#pragma once

#include "game/budget/knob.hpp"
#include "physics/inverse_square/points.hpp"
#include "runtime/world/world.hpp"

#include <functional>
#include <map>
#include <span>
#include <vector>

namespace trembler::budget {

/// A sample of the objects that forces can move: they have a mass and are not fixed.
struct Sample {
    struct Body {
        ObjectId object;
        double mass = 0; ///< kg
    };
    std::vector<Body> bodies; ///< ascending

    /// Index of an object in `bodies`, or -1.
    [[nodiscard]] int find(std::uint32_t index) const;
};

inline constexpr std::size_t sampleSize = 16;

/// At most sampleSize of the objects for which `counts` returns true, evenly spread over their ids.
[[nodiscard]] Sample sampleOf(World const& world, std::function<bool(ObjectId)> const& counts);

/// The error of `forces` against the exact forces `right` (N, one per body of the sample). A force error dF
/// displaces a free body of mass m by ½ dF/m · (1 s)² within the first second; a body that is held
/// elastically with `stiffness` (N/m, one per body; 0: free), as a floating body is by the liquid, by at most
/// dF/stiffness.
[[nodiscard]] Error errorOf(Sample const& sample, std::span<Vec2 const> forces, std::span<Vec2 const> right,
                            std::span<double const> stiffness = {});

/// One inverse-square sum of an effect: its sources, and those of its receivers that are in the sample.
struct SampledSum {
    inverse_square::Points sources;
    inverse_square::Points receivers; ///< only receivers that belong to the sample
    double softening2 = 0;            ///< m²

    /// Keeps those of `all` receivers whose owners are in the sample.
    void receive(inverse_square::Points const& all, Sample const& sample);
    /// Moves all sources and receivers by their owners' velocities times `seconds`.
    void moveOn(World const& world, double seconds);
};

/// Adds the forces of the sources on each receiver to `totals`.
using AddUp = std::function<void(SampledSum const&, std::span<Vec2> totals)>;

/// Forces in N for each body of the sample, of all sums together.
[[nodiscard]] std::vector<Vec2> forcesOn(Sample const& sample, std::span<SampledSum const> sums,
                                         AddUp const& addUp);

void addPairs(SampledSum const& sum, std::span<Vec2> totals);
/// Sums that are cut off smoothly between the distances `inner` and `cutoff` (m).
[[nodiscard]] AddUp byGrid(double inner, double cutoff);

/// The error of forces that are reused for several frames while the objects move: on average they are (period
/// - 1) / 2 frames old. Each period is computed once and cached.
class Staleness {
public:
    /// All arguments must outlive it; `right` are the current exact forces.
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
