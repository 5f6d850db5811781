// Paths, which are any bytes, in files whose text has to be UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace trembler {

/// UTF-8 is unchanged; each byte that is not part of it becomes U+0000 and two hexadecimal digits. No path
/// contains U+0000, so paths that differ stay different. Thread-safe.
[[nodiscard]] std::string pathAsText(std::string_view path);
/// The path that pathAsText() was given. Of any other text, U+0000 without two digits stays. Thread-safe.
[[nodiscard]] std::string pathFromText(std::string_view text);

} // namespace trembler
