// The sounds of a frame, grouped by place, so that many of them can be judged at once.
#pragma once

#include "physics/box_tree.hpp"
#include "runtime/object/object_id.hpp"
#include "runtime/trace/event.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace trembler {

/// Something that sounds in this frame.
struct SoundSource {
    ObjectId object;
    Vec2 at;              ///< m
    double loudness = 0;  ///< Pa² at 1 m
    double frequency = 0; ///< Hz
    EventId event;
};

/// A hierarchy of groups of sources, halved along their longer extent until few are left. Takes n log n to
/// build. The sources must outlive it. Reads are thread-safe.
class SourceTree {
public:
    struct Group {
        Bounds bounds;
        double loudest = 0;         ///< Pa² at 1 m, the greatest
        double lowestFrequency = 0; ///< Hz
        std::uint32_t first = 0;    ///< its sources are order()[first] to order()[last - 1]
        std::uint32_t last = 0;
        std::uint32_t second = 0; ///< its second half; the first half is the next group; 0: it has no halves
        [[nodiscard]] std::uint32_t size() const { return last - first; }
    };

    explicit SourceTree(std::span<SoundSource const> sources);

    [[nodiscard]] std::span<SoundSource const> sources() const { return sources_; }
    /// The first one contains all sources; none if there are no sources.
    [[nodiscard]] std::span<Group const> groups() const { return groups_; }
    [[nodiscard]] std::span<std::uint32_t const> membersOf(Group const& group) const {
        return std::span(order_).subspan(group.first, group.size());
    }

private:
    void halve(std::uint32_t first, std::uint32_t last);

    std::span<SoundSource const> sources_;
    std::vector<std::uint32_t> order_;
    std::vector<Group> groups_;
};

} // namespace trembler
