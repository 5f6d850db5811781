// The call by which interactions request frames in parts.
#pragma once

#include "runtime/component/call.hpp"
#include "runtime/property/description.hpp"

#include <array>

namespace trembler {

/// Requests that frames are computed in parts no longer than `longest`, from the next frame on. Of several
/// such calls the one with the shortest parts counts; a frame has at most mostParts. A `longest` that is not
/// above zero has no effect.
struct SplitFrame {
    static constexpr CallText text{"splitFrame", "(longest)",
                                   "Requests parts of a frame that are no longer than this (s)."};
    static constexpr Algebra algebra = Algebra::least;
    double longest = 0; ///< s

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "longest",
                        .unit = "s",
                        .meaning = "length of a part; at or below 0 asks for nothing",
                        .minimum = 0,
                        .maximum = 1,
                        .required = true},
              self.longest);
    }
    [[nodiscard]] std::array<ObjectId, 0> objects() const { return {}; }
    [[nodiscard]] int key() const { return 0; }
    [[nodiscard]] double value() const { return longest; }
};

struct FrameRole {
    static constexpr std::string_view name = "Frame";
    using Calls = CallList<SplitFrame>;
};

} // namespace trembler
