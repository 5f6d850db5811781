// How a frame gets its parts: asked for from the interaction layer, as everything.
#pragma once

#include "runtime/component/call.hpp"

#include <array>

namespace trembler {

/// Asks for the coming frames to be computed in parts that are no longer than `longest`. While several ask,
/// the shortest counts; there are at most mostParts. What is no positive number asks for nothing.
struct SplitFrame {
    static constexpr CallText text{"splitFrame", "(longest)",
                                   "Asks for parts of a frame that are no longer than this (s)."};
    static constexpr Algebra algebra = Algebra::least;
    double longest = 0; ///< s

    [[nodiscard]] std::array<ObjectId, 0> objects() const { return {}; }
    [[nodiscard]] int key() const { return 0; }
    [[nodiscard]] double value() const { return longest; }
};

struct FrameRole {
    static constexpr std::string_view name = "Frame";
    using Calls = CallList<SplitFrame>;
};

} // namespace trembler
