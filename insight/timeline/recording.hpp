// Everything that was computed in a run, frame by frame, in bounded memory.
#pragma once

#include "insight/timeline/packed_frames.hpp"
#include "insight/timeline/recorded_properties.hpp"
#include "puzzle/goals/goal_judge.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace trembler::insight {

/// The part of the world's state whose value a part of a recorded frame holds.
struct RecordedPart {
    enum class Kind : std::uint8_t {
        column,  ///< of an object property: `property`
        slot,    ///< a resolver or derived property: `property`
        objects, ///< the objects that exist, with their names, if that has changed since the beginning
        goals,   ///< for each goal whether it is met, its progress, and the frame in which it was met
    };
    Kind kind = Kind::column;
    PropertyInfo const* property = nullptr; ///< nullptr: of neither a column nor a slot
};

/// Follows one run at a time. It only reads, and makes the world compute nothing that it would not compute
/// anyway. Recent frames are kept as they are, older ones compressed in blocks; where more memory is used
/// than allowed, the oldest are thinned out: of a block every second frame remains, then every fourth, in the
/// end its first. Not thread-safe.
class Recording {
public:
    static constexpr std::size_t usualBytes = std::size_t{32} << 20U;
    static constexpr std::size_t framesInBlock = 64;

    explicit Recording(std::size_t mostBytes = usualBytes) : mostBytes_(mostBytes) {}

    /// Forgets everything and begins with a run as it is now, before its first frame.
    void begin(World const& world, GoalJudge const& judge);
    [[nodiscard]] bool begun() const { return !parts_.empty(); }
    /// Records the frame that the run has just computed. Frames that are not later than the last one are
    /// ignored.
    void add(World const& world, GoalJudge const& judge);
    /// Forgets all frames after that one.
    void forgetAfter(std::uint64_t frame);
    void clear();

    /// The last recorded frame; 0 before the first.
    [[nodiscard]] std::uint64_t last() const;
    /// The number of the recorded frame that is nearest to `frame`, the earlier of two.
    [[nodiscard]] std::uint64_t nearest(std::uint64_t frame) const;
    /// The recorded frame after `frame`, or before it; nothing if there is none.
    [[nodiscard]] std::optional<std::uint64_t> after(std::uint64_t frame) const;
    [[nodiscard]] std::optional<std::uint64_t> before(std::uint64_t frame) const;
    /// The frame nearest to `frame`. Valid until the recording changes or another one is asked for.
    [[nodiscard]] RecordedFrame const& at(std::uint64_t frame) const;
    /// The parts of a frame. Later frames may add parts.
    [[nodiscard]] std::vector<RecordedPart> const& parts() const { return parts_; }
    /// The values at the beginning, one for each part; null: there was no such part.
    [[nodiscard]] std::vector<SharedWords> const& beginning() const { return beginning_; }

    /// How many frames are recorded, the beginning included.
    [[nodiscard]] std::size_t frames() const;
    /// Bytes of memory in use for frames, without the block that is being read.
    [[nodiscard]] std::size_t bytes() const { return packedBytes_ + looseBytes(); }

private:
    struct Block {
        std::shared_ptr<PackedFrames const> packed;
        std::uint32_t stride = 1; // one of this many frames is left
    };

    RecordedFrame look(World const& world, GoalJudge const& judge);
    void lookAtColumns(Store const& store);
    void lookAtSlots(Store const& store);
    void lookAtObjects(Store const& store);
    void lookAtGoals(GoalJudge const& judge);
    /// The place of a part in parts_, which gets it if it lacks it.
    std::size_t place(RecordedPart const& part);
    /// Makes the words the latest value of a part.
    void keep(std::size_t part, Words words);
    void pack();
    void thin();
    [[nodiscard]] std::size_t looseBytes() const;
    [[nodiscard]] std::vector<RecordedFrame> const& unpacked(Block const& block) const;
    /// The block with the first frame not after `frame`, or the number of blocks.
    [[nodiscard]] std::size_t blockOf(std::uint64_t frame) const;

    std::size_t mostBytes_;
    std::vector<RecordedPart> parts_;
    std::map<std::pair<RecordedPart::Kind, std::string_view>, std::size_t> places_; // by the property's key
    std::vector<SharedWords> beginning_;
    std::vector<SharedWords> latest_;     // one for each part; null: as at the beginning
    std::vector<std::uint64_t> versions_; // of columns and slots, as of latest_
    std::uint64_t structure_ = 0;         // of the store, as of latest_
    std::vector<Block> blocks_;           // ascending
    std::vector<RecordedFrame> loose_;    // after them; begins with frame 0
    std::size_t packedBytes_ = 0;
    std::size_t freshBytes_ = 0; // of loose_, about: what looseBytes() counts takes time
    struct Open {
        std::shared_ptr<PackedFrames const> of;
        std::vector<RecordedFrame> frames;
    };
    mutable std::deque<Open> open_; // blocks that were read last, the latest first
};

} // namespace trembler::insight
