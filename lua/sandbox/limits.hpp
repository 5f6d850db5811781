// The limits of a script in one frame. Everything is counted in instructions and bytes, never in time, so a
// script is stopped at the same instruction on every machine. Instructions are those of its text: see
// CountedSource.
#pragma once

#include <cstddef>
#include <cstdint>

namespace trembler::lua {

/// Limits of one frame, for all turns of one scripted interaction in it together: one turn in each part of
/// the frame, or a single one. So they bound how much longer a frame takes, however many parts it has. Limits
/// "per object" are added for each object, or pair, that the script is applied to, in every turn: an
/// interaction with eight times the objects may do eight times the work.
struct ScriptLimits {
    std::uint64_t instructions = 15'000;
    std::uint64_t instructionsPerObject =
        500; ///< on average: an object may use instructions that others leave
    /// Bytes by which the memory in use may grow in a turn, which begins without the memory that the turn
    /// before has used. Garbage of one application counts until its end.
    std::size_t memory = std::size_t{4} << 20U;
    /// Bytes, summed over all allocations in a frame, less the old sizes of blocks that grow.
    std::size_t allocation = std::size_t{4} << 20U;
    std::size_t allocationPerObject = 1024; ///< bytes
    std::uint32_t calls = 100;              ///< of functions of the resolver
    std::uint32_t callsPerObject = 10;
    std::uint32_t creations = 20; ///< of these, calls that create objects
    std::uint32_t logLines = 10;

    /// The greatest limits that a manifest may state.
    [[nodiscard]] static constexpr ScriptLimits greatest() {
        return {.instructions = 200'000,
                .instructionsPerObject = 2'000,
                .memory = std::size_t{16} << 20U,
                .allocation = std::size_t{16} << 20U,
                .allocationPerObject = 4096,
                .calls = 1'000,
                .callsPerObject = 100,
                .creations = 200,
                .logLines = 100};
    }
};

/// How far a script's author is trusted. This changes how a script is run, but none of its results, which are
/// the same for both, bit for bit.
enum class Trust {
    /// Interpreted only; no FFI in its state; blocks of memory are bounded.
    untrusted,
    /// Compiled, and columns are read by FFI. Instructions and calls have the same limits. The limit of
    /// memory is four times as much, and there is none for single blocks or for the sum of a frame, as
    /// compiled code allocates less.
    trusted,
};

/// Limits that no manifest can change.
inline constexpr std::size_t longestSource = 65'536; ///< bytes of a script
inline constexpr std::size_t longestLiteral = 1'000; ///< bytes of a string that a script states
inline constexpr std::size_t longestString = 1'000;  ///< bytes of one that it makes
inline constexpr std::size_t longestNumber = 24; ///< characters of a text that arithmetic takes for a number
inline constexpr std::size_t longestLogLine = 300; ///< bytes
/// Pairs of objects that a script is applied to in one turn: their number grows with the square of that of
/// objects.
inline constexpr std::size_t mostPairs = 100'000;
/// Bytes of one new block: it bounds the length of strings, and so the work of one instruction on them.
inline constexpr std::size_t largestNewBlock = 8'192;
/// Bytes to which a block may grow: it bounds the length of arrays and the depth of the stack.
inline constexpr std::size_t largestGrownBlock = 32'768;
/// Bytes of the table of all strings of a state: 8 for each of them.
inline constexpr std::size_t largestTableOfStrings = std::size_t{1} << 20U;
/// Bytes by which an untrusted script's memory grows at least, between two collections of garbage.
inline constexpr std::size_t leastGarbage = std::size_t{128} << 10U;

} // namespace trembler::lua
