// How long the texts of files may be. The schema states the length of values; a file that exceeds one is
// rejected with a message.
#pragma once

#include <cstddef>

namespace trembler::limits {

/// Bytes of a key of an object.
inline constexpr std::size_t key = 1000;
/// Bytes of a text: what people read, a value of a property.
inline constexpr std::size_t text = 100'000;

} // namespace trembler::limits
