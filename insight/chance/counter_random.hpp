// Random numbers that are a pure function of a key and of how many were drawn before.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace trembler::insight {

/// A key for one purpose: from the user's seed, names (of a level, a solution, a purpose) and a number. The
/// order of names matters, and where one ends and the next begins. A pure function, the same on every
/// machine.
[[nodiscard]] std::uint64_t keyOf(std::uint64_t seed, std::initializer_list<std::string_view> names,
                                  std::uint64_t number = 0);

/// The nth number is a mixing function of the key and n (SplitMix64: Steele, Lea and Flood, Fast Splittable
/// Pseudorandom Number Generators, 2014). So the numbers of one piece of work depend on nothing but its key:
/// not on the work done before, nor on the thread or the process that does it. Only whole numbers, sums,
/// products and quotients are used: no library function that may round differently elsewhere. One thread at a
/// time.
class CounterRandom {
public:
    explicit CounterRandom(std::uint64_t key) : key_(key) {}

    [[nodiscard]] std::uint64_t next();
    /// From 0 to below 1, in steps of 2^-53.
    [[nodiscard]] double unit();
    /// From `low` to below `high`, evenly.
    [[nodiscard]] double between(double low, double high) { return low + (high - low) * unit(); }
    /// From 0 to below `count`, which must not be 0.
    [[nodiscard]] std::size_t below(std::size_t count);
    /// True with that probability.
    [[nodiscard]] bool chance(double probability) { return unit() < probability; }
    /// Around 0, between -1 and 1, more often small than large: the mean of three even ones.
    [[nodiscard]] double bell();

private:
    std::uint64_t key_;
    std::uint64_t drawn_ = 0;
};

} // namespace trembler::insight
