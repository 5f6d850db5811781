// Some successive frames of a recording, compressed.
#pragma once

#include "insight/timeline/recorded_frame.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace trembler::insight {

/// Lossless. A value that is the same as in the frame before costs a bit or so. Of others, each word is
/// predicted to change as it did before (linearly, in integer arithmetic of its bits, which is exact), the
/// difference is taken, and the bytes of equal weight are put side by side for zlib. Words of single
/// precision, as Box2D's are, keep their zeros that way.
///
/// The first frame is a key: it does not depend on other blocks. Immutable; thread-safe.
class PackedFrames {
public:
    /// At least one frame, ascending by number.
    explicit PackedFrames(std::span<RecordedFrame const> frames);

    /// All of them, bit for bit as they were.
    [[nodiscard]] std::vector<RecordedFrame> unpacked() const;
    [[nodiscard]] std::size_t size() const { return numbers_.size(); }
    /// The numbers of the frames, ascending.
    [[nodiscard]] std::span<std::uint64_t const> numbers() const { return numbers_; }
    /// Bytes that it occupies.
    [[nodiscard]] std::size_t bytes() const {
        return sizeof(*this) + packed_.capacity() + numbers_.capacity() * sizeof(std::uint64_t);
    }

private:
    std::vector<std::uint64_t> numbers_;
    std::uint64_t words_ = 0; // of the stream before it was packed
    std::string packed_;
};

} // namespace trembler::insight
