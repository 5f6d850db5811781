// How much a level file may hold. The schema states these numbers; a file that exceeds one is rejected with a
// message.
#pragma once

#include <cstddef>
#include <cstdint>

namespace trembler::limits {

/// Of a file, in bytes. A level of a hundred thousand objects has about a fifth of this size.
inline constexpr std::size_t fileSize = std::size_t{64} << 20U;
/// Depth of nested lists and objects. Files of the project need about ten.
inline constexpr std::size_t depth = 64;
/// Values of any kind in one file: the memory for a file depends more on their number than on its size.
inline constexpr std::size_t values = 4'000'000;

inline constexpr std::size_t objects = 200'000;
/// Objects and joints of a world, those of composite parts included.
inline constexpr std::size_t made = 1'000'000;
/// Of one composite part, those of its pieces included.
inline constexpr std::size_t pieces = 1000;
/// Parts inside one another.
inline constexpr std::size_t partDepth = 8;
/// Bytes of a name.
inline constexpr std::size_t name = 100;
/// Of a list inside a property, unless its description states less.
inline constexpr std::size_t listInProperty = 10'000;
inline constexpr std::size_t joints = 200'000;
inline constexpr std::size_t connections = 400'000;
inline constexpr std::size_t areas = 1000;       ///< "placing"
inline constexpr std::size_t areaCorners = 1000; ///< of one area
inline constexpr std::size_t toolboxEntries = 1000;
inline constexpr std::int64_t toolboxCount = 1000; ///< of one part
inline constexpr std::size_t hints = 1000;
inline constexpr std::size_t conditions = 10'000; ///< of the goals, nested ones included
inline constexpr std::size_t solutions = 1000;
inline constexpr std::size_t placements = 100'000; ///< of one solution
inline constexpr std::size_t inputs = 1'000'000;   ///< of one solution
inline constexpr std::size_t changes = 100'000;    ///< of one solution
/// Of a recording, about two days; also the limit of a run.
inline constexpr std::int64_t frames = 10'000'000;

} // namespace trembler::limits
