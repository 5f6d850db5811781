// How long the texts of files may be. The schema states the length of values; a file that exceeds one is
// rejected with a message.
#pragma once

#include <cstddef>

namespace trembler::limits {

/// Bytes of a key of an object.
inline constexpr std::size_t key = 1000;
/// Bytes of a text in a property: a name, a file, a sign. Every object has its own copy of each, so it is
/// short.
inline constexpr std::size_t textInProperty = 300;
/// Bytes of a text that people read.
inline constexpr std::size_t text = 100'000;

} // namespace trembler::limits
