// How the state hash covers data outside columns: stated beside the data, checked and printed.
#pragma once

#include <concepts>
#include <cstdint>
#include <string_view>

namespace trembler {

/// How the state hash covers a property or a component's memory. Equal hashes mean equal worlds, so all data
/// on which later frames depend must be hashed, or state why they need not be.
struct Coverage {
    enum class Kind : std::uint8_t { hashed, derived, leftOut };
    Kind kind = Kind::hashed;
    std::string_view reason{}; ///< why it need not be hashed
};

/// Every member is hashed, except ids of trace events, on which no computation depends.
inline constexpr Coverage hashed{};
/// Computed from scratch in each turn of the component that provides it, from hashed data only. It is hashed
/// only where that component has a period, as the value may then stem from an earlier frame. The reason names
/// the data that it is computed from.
[[nodiscard]] constexpr Coverage derivedFrom(std::string_view reason) {
    return {Coverage::Kind::derived, reason};
}
/// Never hashed. The reason says why no later frame depends on it, or why it cannot be hashed.
[[nodiscard]] constexpr Coverage leftOut(std::string_view reason) {
    return {Coverage::Kind::leftOut, reason};
}

/// A type that states `static constexpr Coverage coverage = leftOut("why")`: an object property, or a member
/// of one, that is only shown and that no component reads.
template <class T>
concept LeftOutOfHash = requires {
    { T::coverage } -> std::convertible_to<Coverage>;
}
&&T::coverage.kind == Coverage::Kind::leftOut;

} // namespace trembler
