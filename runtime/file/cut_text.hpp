// Text from files, cut to a length that people can read.
#pragma once

#include <cstddef>
#include <string>

namespace trembler {

/// The text if it has at most `most` bytes, else so many whole characters of it as fit, and "...". Characters
/// are those of UTF-8; bytes that are none are counted as one each. Thread-safe.
[[nodiscard]] std::string cutText(std::string text, std::size_t most);

} // namespace trembler
