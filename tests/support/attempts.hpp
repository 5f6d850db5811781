// How many attempts a test with random input makes.
#pragma once

#include <algorithm>
#include <cstdlib>

namespace trembler::test {

/// The `usual` number of attempts, or that times the environment's TREMBLER_FUZZ: 50 makes fifty times as
/// many, 0.1 a tenth, but no less than `least`.
[[nodiscard]] inline unsigned attempts(unsigned usual, unsigned least = 1) {
    char const* const factor = std::getenv("TREMBLER_FUZZ");
    double const times = factor == nullptr ? 1 : std::strtod(factor, nullptr);
    return static_cast<unsigned>(std::max(static_cast<double>(least), usual * times));
}

} // namespace trembler::test
