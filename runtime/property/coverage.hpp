// How the state hash covers what is not a column: stated beside each thing, checked and printed.
#pragma once

#include <cstdint>
#include <string_view>

namespace trembler {

/// Equal hashes mean equal worlds: whatever decides what comes next is hashed, or it is said why not.
struct Coverage {
    enum class Kind : std::uint8_t { hashed, derived, leftOut };
    Kind kind = Kind::hashed;
    std::string_view reason{}; ///< why it need not be hashed
};

/// Every member is hashed, but for the events of the trace, which lead to nothing.
inline constexpr Coverage hashed{};
/// Worked out again, by each turn of the component that provides it, from what is hashed: so it is hashed
/// only where that component has a period and the value is one of earlier frames. The reason says from what.
[[nodiscard]] constexpr Coverage derivedFrom(std::string_view reason) {
    return {Coverage::Kind::derived, reason};
}
/// Never hashed. The reason says why nothing that comes next depends on it, or what hinders.
[[nodiscard]] constexpr Coverage leftOut(std::string_view reason) {
    return {Coverage::Kind::leftOut, reason};
}

} // namespace trembler
