// How much the folders may hold from which files of the same kind are read.
#pragma once

#include "runtime/level/json/limits.hpp"

#include <cstddef>
#include <cstdint>

namespace trembler::limits {

/// Files of parts in one folder, and their bytes together.
inline constexpr std::size_t partFiles = 5000;
inline constexpr std::uintmax_t partBytes = fileSize;
/// Levels below one folder.
inline constexpr std::size_t levelFiles = 10'000;

} // namespace trembler::limits
