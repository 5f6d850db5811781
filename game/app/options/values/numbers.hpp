// Parses decimal numbers from command lines, strictly.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace trembler {

/// A whole number from `least` to `most` in decimal digits, with a minus sign if it is negative. Nothing if
/// the text is anything else: no blanks, no "+", no leading zeros (which elsewhere mean base eight), no
/// exponent.
[[nodiscard]] std::optional<std::int64_t> wholeNumber(std::string_view text, std::int64_t least,
                                                      std::int64_t most);

/// A finite number from `least` to `most`, such as 2, 0.5 or 1e-3. Nothing if the text is anything else.
[[nodiscard]] std::optional<double> decimalNumber(std::string_view text, double least, double most);

} // namespace trembler
