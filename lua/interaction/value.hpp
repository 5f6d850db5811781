// Values that a script's manifest, its store and its parameters consist of.
#pragma once

#include "runtime/math/vec2.hpp"

#include <string>
#include <string_view>
#include <variant>

namespace trembler::lua {

using Value = std::variant<bool, double, Vec2, std::string>;

/// "a boolean", "a number", "a vector", "a text".
[[nodiscard]] std::string_view kindOf(Value const& value);
/// Whether all its numbers are finite.
[[nodiscard]] bool isFinite(Value const& value);

/// Bytes of a text in a store, or of a parameter.
inline constexpr std::size_t longestText = 100;

} // namespace trembler::lua
