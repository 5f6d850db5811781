#include "insight/chance/counter_random.hpp"

namespace trembler::insight {
namespace {

constexpr std::uint64_t goldenStep = 0x9e3779b97f4a7c15ULL; // 2^64 divided by the golden ratio, odd

/// A bijection of 64 bits in which every bit of the argument affects every bit of the result.
constexpr std::uint64_t mixedBits(std::uint64_t z) {
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31U);
}

} // namespace

std::uint64_t keyOf(std::uint64_t seed, std::initializer_list<std::string_view> names, std::uint64_t number) {
    std::uint64_t key = mixedBits(seed + goldenStep);
    for (std::string_view const name : names) {
        for (char const c : name) {
            key = mixedBits(key + goldenStep + static_cast<unsigned char>(c));
        }
        key = mixedBits(key + goldenStep + 256); // no char: the end of a name
    }
    return mixedBits(key ^ mixedBits(number + goldenStep));
}

std::uint64_t CounterRandom::next() {
    return mixedBits(key_ + goldenStep * ++drawn_);
}

double CounterRandom::unit() {
    return static_cast<double>(next() >> 11U) * 0x1p-53;
}

std::size_t CounterRandom::below(std::size_t count) {
    // The excess of some results over others is below count / 2^64.
    return static_cast<std::size_t>(next() % count);
}

double CounterRandom::bell() {
    double const a = between(-1, 1);
    double const b = between(-1, 1);
    return (a + b + between(-1, 1)) / 3;
}

} // namespace trembler::insight
