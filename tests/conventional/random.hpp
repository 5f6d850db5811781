// Random numbers that are the same with every library.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

namespace trembler::conventional {

class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    /// From low to high.
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
    }
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
    template <class T>
    T const& oneOf(std::vector<T> const& all) {
        return all[below(all.size())];
    }
    bool chance(double share) { return between(0, 1) < share; }

private:
    std::mt19937_64 engine_;
};

} // namespace trembler::conventional
