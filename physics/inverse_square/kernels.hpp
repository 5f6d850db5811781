// The innermost loops of inverse-square sums: four receivers at a time, source by source.
#pragma once

#include "physics/inverse_square/points.hpp"

#include <span>

namespace trembler::inverse_square {

/// The number of receivers that are summed together. Each has its own sum, source by source in their order,
/// so every bit is that of a plain loop, for any width of the processor's vectors.
inline constexpr std::size_t blockSize = 4;

struct alignas(32) Block {
    double x[blockSize];
    double y[blockSize];
    double weight[blockSize];
    double owner[blockSize];
    double sumX[blockSize];
    double sumY[blockSize];
    double stiffness[blockSize]; ///< see addAllPairs()
};

/// A far cluster of sources: moments about a centre up to the second.
struct Cluster {
    double x = 0; ///< m, the centre
    double y = 0;
    double weight = 0;  ///< Σ w
    double dipoleX = 0; ///< Σ w δ, δ from the centre
    double dipoleY = 0;
    double xx = 0; ///< Σ w δx²
    double xy = 0;
    double yy = 0;
    double absolute = 0; ///< Σ |w|
};

/// Reduces the sums smoothly to zero between `inner` and `outer` (m), by the factor t² (3 - 2 t) with t =
/// (outer² - r²) / (outer² - inner²), clamped to 0 and 1.
struct Window {
    double outerSquared = 0;
    double inverseSpan = 0;
    Window() = default;
    Window(double inner, double outer)
        : outerSquared(outer * outer), inverseSpan(1 / (outer * outer - inner * inner)) {}
};

/// One implementation for one kind of processor. All of them give the same bits: additions,
/// multiplications, divisions and roots are correctly rounded in vectors of every width.
struct Kernels {
    char const* name;
    std::size_t width;
    /// Adds the contributions of the sources in [begin, end) to the block's sums. `softening2` = s² > 0, m².
    void (*addPairs)(Points const&, std::size_t begin, std::size_t end, double softening2, Block&);
    void (*addWindowed)(Points const&, std::size_t begin, std::size_t end, double softening2, Window const&,
                        Block&);
    /// The Taylor expansion of the same sum about the cluster's centre, up to second order: its relative
    /// error is about (size of the cluster / its distance)³.
    void (*addClusters)(std::span<Cluster const>, double softening2, Block&);
};

/// All implementations that this processor can run, narrowest first; at least one.
[[nodiscard]] std::span<Kernels const> availableKernels();
/// The widest available implementation.
[[nodiscard]] Kernels const& kernels();

/// Adds the contributions of all sources at receiver i to totals[i], for i in [begin, end): O(sources ·
/// receivers). Adds to stiffness[i], if not empty, how much these vary with the receiver's place, without
/// signs:
///     |f_i| Σ |w_j| / (r_ij² + s²)^(3/2).
/// That is the derivative across r; the one along r is between 1 and -2 times as much.
void addAllPairs(Points const& sources, Points const& receivers, std::size_t begin, std::size_t end,
                 double softening2, std::span<Vec2> totals, std::span<double> stiffness = {});

/// Copies receivers into a block: row(k) among the receivers and totalRow(k) among the totals, for k in [0,
/// count), 0 < count <= blockSize. The rest of the block repeats the last receiver.
template <class Row, class TotalRow>
void fillBlock(Block& block, Points const& receivers, std::span<Vec2 const> totals, std::size_t count,
               Row&& row, TotalRow&& totalRow) {
    for (std::size_t k = 0; k < blockSize; ++k) {
        std::size_t const i = row(k < count ? k : count - 1);
        Vec2 const total = totals[totalRow(k < count ? k : count - 1)];
        block.x[k] = receivers.x[i];
        block.y[k] = receivers.y[i];
        block.weight[k] = receivers.weight[i];
        block.owner[k] = receivers.owner[i];
        block.sumX[k] = total.x;
        block.sumY[k] = total.y;
        block.stiffness[k] = 0;
    }
}
template <class TotalRow>
void emptyBlock(Block const& block, std::span<Vec2> totals, std::span<double> stiffness, std::size_t count,
                TotalRow&& totalRow) {
    for (std::size_t k = 0; k < count; ++k) {
        totals[totalRow(k)] = {block.sumX[k], block.sumY[k]};
        if (!stiffness.empty()) {
            stiffness[totalRow(k)] += block.stiffness[k];
        }
    }
}

} // namespace trembler::inverse_square
