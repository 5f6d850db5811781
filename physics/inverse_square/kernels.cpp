#include "physics/inverse_square/kernels.hpp"

#include <algorithm>
#include <vector>

#if defined(__SSE2__)
#include <immintrin.h>
#define TREMBLER_X86_VECTORS
#endif

namespace trembler::inverse_square {
namespace {

// One number at a time, for any processor and as the reference for tests of the others.
namespace one {
#define TREMBLER_VECTOR double
#define TREMBLER_WIDTH 1
#define TREMBLER_TARGET
#define SET(a) (a)
#define LOAD(p) (*(p))
#define STORE(p, v) (*(p) = (v))
#define SQRT(v) std::sqrt(v)
#define SIZE(v) std::abs(v)
#define ATMOST(a, b) ((a) < (b) ? (a) : (b))
#define ATLEAST(a, b) ((a) > (b) ? (a) : (b))
#define UNLESS_EQUAL(a, b, v) ((a) != (b) ? (v) : 0.0)
#include "physics/inverse_square/kernels.inc"
#undef TREMBLER_VECTOR
#undef TREMBLER_WIDTH
#undef TREMBLER_TARGET
#undef SET
#undef LOAD
#undef STORE
#undef SQRT
#undef SIZE
#undef ATMOST
#undef ATLEAST
#undef UNLESS_EQUAL
} // namespace one

#ifdef TREMBLER_X86_VECTORS

// Two at a time: every x86-64 processor.
namespace two {
#define TREMBLER_VECTOR __m128d
#define TREMBLER_WIDTH 2
#define TREMBLER_TARGET
#define SET(a) _mm_set1_pd(a)
#define LOAD(p) _mm_load_pd(p)
#define STORE(p, v) _mm_store_pd(p, v)
#define SQRT(v) _mm_sqrt_pd(v)
#define SIZE(v) _mm_andnot_pd(_mm_set1_pd(-0.0), v)
#define ATMOST(a, b) _mm_min_pd(a, b)
#define ATLEAST(a, b) _mm_max_pd(a, b)
#define UNLESS_EQUAL(a, b, v) _mm_and_pd(_mm_cmpneq_pd(a, b), v)
#include "physics/inverse_square/kernels.inc"
#undef TREMBLER_VECTOR
#undef TREMBLER_WIDTH
#undef TREMBLER_TARGET
#undef SET
#undef LOAD
#undef STORE
#undef SQRT
#undef SIZE
#undef ATMOST
#undef ATLEAST
#undef UNLESS_EQUAL
} // namespace two

// Four at a time. AVX without fused multiply-add, which would round differently.
namespace four {
#define TREMBLER_VECTOR __m256d
#define TREMBLER_WIDTH 4
#define TREMBLER_TARGET __attribute__((target("avx")))
#define SET(a) _mm256_set1_pd(a)
#define LOAD(p) _mm256_load_pd(p)
#define STORE(p, v) _mm256_store_pd(p, v)
#define SQRT(v) _mm256_sqrt_pd(v)
#define SIZE(v) _mm256_andnot_pd(_mm256_set1_pd(-0.0), v)
#define ATMOST(a, b) _mm256_min_pd(a, b)
#define ATLEAST(a, b) _mm256_max_pd(a, b)
#define UNLESS_EQUAL(a, b, v) _mm256_and_pd(_mm256_cmp_pd(a, b, _CMP_NEQ_UQ), v)
#include "physics/inverse_square/kernels.inc"
#undef TREMBLER_VECTOR
#undef TREMBLER_WIDTH
#undef TREMBLER_TARGET
#undef SET
#undef LOAD
#undef STORE
#undef SQRT
#undef SIZE
#undef ATMOST
#undef ATLEAST
#undef UNLESS_EQUAL
} // namespace four

#endif

std::vector<Kernels> found() {
    std::vector<Kernels> all{{"scalar", 1, one::addPairs, one::addWindowed, one::addClusters}};
#ifdef TREMBLER_X86_VECTORS
    all.push_back({"SSE2", 2, two::addPairs, two::addWindowed, two::addClusters});
    if (__builtin_cpu_supports("avx") != 0) {
        all.push_back({"AVX", 4, four::addPairs, four::addWindowed, four::addClusters});
    }
#endif
    return all;
}

} // namespace

std::span<Kernels const> availableKernels() {
    static std::vector<Kernels> const all = found();
    return all;
}

Kernels const& kernels() {
    static Kernels const& widest = availableKernels().back();
    return widest;
}

void addAllPairs(Points const& sources, Points const& receivers, std::size_t begin, std::size_t end,
                 double softening2, std::span<Vec2> totals, std::span<double> stiffness) {
    Kernels const& run = kernels();
    Block block;
    for (std::size_t i = begin; i < end; i += blockSize) {
        std::size_t const count = std::min(blockSize, end - i);
        auto const row = [i](std::size_t k) { return i + k; };
        fillBlock(block, receivers, totals, count, row, row);
        run.addPairs(sources, 0, sources.size(), softening2, block);
        emptyBlock(block, totals, stiffness, count, row);
    }
}

} // namespace trembler::inverse_square
