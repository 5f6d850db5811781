// How often the toolbox of a level has a part, or a wire.
#pragma once

#include <limits>
#include <string_view>

namespace trembler {

/// As often as the player likes: a count of its own, which stays the same whatever is taken.
inline constexpr int unlimitedCount = std::numeric_limits<int>::max();
/// The same in files, in place of a number.
inline constexpr std::string_view unlimitedWord = "unlimited";

/// How many are left of `count` after `used` were taken. Below zero if more were taken than there are.
[[nodiscard]] constexpr int leftOf(int count, int used) {
    return count == unlimitedCount ? unlimitedCount : count - used;
}

} // namespace trembler
