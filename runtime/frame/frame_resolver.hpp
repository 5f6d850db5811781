// The resolver that decides in how many parts a frame is computed.
#pragma once

#include "runtime/component/resolver.hpp"
#include "runtime/frame/calls.hpp"
#include "runtime/frame/settings.hpp"
#include "runtime/property/coverage.hpp"

namespace trembler {

/// The number of parts of the current frame; between frames, of the last one.
struct FrameParts {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Frame parts", "frame_parts",
                                       "The number of equal parts in which the frame is computed."};
    static constexpr Coverage coverage = hashed;
    static constexpr std::string_view standing = "the number of parts of the frame";
    std::int32_t parts = 1; ///< 1, 2, 4 or 8

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "parts",
                        .unit = "",
                        .meaning = "number of equal parts in which the frame is computed"},
              self.parts);
    }
};

/// Runs before the first part of each frame and not within it, so the number of parts changes between frames
/// only (World::step()). The world states the number. If it is automatic, frames have the longest parts that
/// all splitFrame() calls allow; these calls are held. So the number depends only on the state at the end of
/// the previous frame.
class FrameResolver final
    : public Resolver<FrameResolver, FrameRole, Reads<FrameSettings>, Writes<>, Provides<FrameParts>> {
public:
    static constexpr ComponentText text{
        .name = "Frame",
        .effect = "frame",
        .level = "",
        .work = "Divides each frame, before it begins, into 1, 2, 4 or 8 equal parts: as many as stated, or "
                "enough for them to be as short as interactions request."};
    using Activation = NeedsAll<>;
    void advance(Access& access);
};

} // namespace trembler
