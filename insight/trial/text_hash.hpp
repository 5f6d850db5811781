// Texts of any length as a few letters of a key.
#pragma once

#include <string>
#include <string_view>

namespace trembler::insight {

/// 16 hex digits of a hash (XXH3) of a text.
[[nodiscard]] std::string hashOf(std::string_view text);

} // namespace trembler::insight
