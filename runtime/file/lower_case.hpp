// Text for comparisons that ignore case.
#pragma once

#include <string>
#include <string_view>

namespace trembler {

/// The letters A to Z as a to z; everything else stays, also other letters of UTF-8. Thread-safe.
[[nodiscard]] std::string inLowerCase(std::string_view text);

} // namespace trembler
