// The resolver that says in how many parts a frame is computed.
#pragma once

#include "runtime/component/resolver.hpp"
#include "runtime/frame/calls.hpp"
#include "runtime/frame/settings.hpp"
#include "runtime/property/coverage.hpp"

namespace trembler {

/// In how many parts the frame that is under way, or was the last, is computed.
struct FrameParts {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Frame parts", "frame_parts",
                                       "In how many equal parts the frame is computed."};
    static constexpr Coverage coverage = hashed;
    static constexpr std::string_view standing = "in how many parts the frame is computed";
    std::int32_t parts = 1; ///< 1, 2, 4 or 8

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "parts", .unit = "", .meaning = "in which the frame is computed"}, self.parts);
    }
};

/// Has its turn before the first part of each frame, and none within it, so parts change between frames only
/// (World::step()). The world's stated number counts; if it is automatic, the longest parts that suit all who
/// ask, whose calls stand since they were last applied. So it follows from the state at the end of the frame
/// before alone.
class FrameResolver final
    : public Resolver<FrameResolver, FrameRole, Reads<FrameSettings>, Writes<>, Provides<FrameParts>> {
public:
    static constexpr ComponentText text{
        .name = "Frame",
        .effect = "frame",
        .level = "",
        .work = "Divides each frame, before it begins, into 1, 2, 4 or 8 equal parts: as stated, or so that "
                "they are as short as somebody asks for."};
    using Activation = NeedsAll<>;
    void advance(Access& access);
};

} // namespace trembler
