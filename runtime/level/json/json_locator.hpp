// Finds the place of a value in the text of a JSON document.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace trembler {

struct TextPlace {
    std::size_t line = 1;   ///< from 1
    std::size_t column = 1; ///< from 1, in characters (code points of UTF-8)
};

/// The place of a byte.
[[nodiscard]] TextPlace placeOf(std::string_view text, std::size_t offset);

enum class Spot {
    value,   ///< where the value begins
    key,     ///< where its key begins
    lastKey, ///< where the last occurrence of its key begins, for repeated keys
};

/// The byte at which the value at a JSON pointer begins, in valid JSON. If there is no such value, the place
/// of the innermost value around it. Walks through the text up to the value; stores nothing, as only problems
/// need places.
[[nodiscard]] std::size_t locate(std::string_view text, std::string_view pointer, Spot spot = Spot::value);

/// The pointer of a member or an element: `~` and `/` in keys are escaped.
[[nodiscard]] std::string pointerTo(std::string_view parent, std::string_view key);
[[nodiscard]] std::string pointerTo(std::string_view parent, std::size_t index);

} // namespace trembler
