// How a joint is drawn if that does not follow from its form. No component reads it.
#pragma once

#include "runtime/property/coverage.hpp"
#include "runtime/property/description.hpp"

#include <array>

namespace trembler {

/// All but `own` and `none` are for joints between two places: distances, ropes, springs and pulleys; belt
/// and chain for gears, too, as a loop around both wheels. Other joints are drawn by their form, or not.
enum class JointDrawn : int { own, none, rope, cord, chain, belt, rod, spring, wire };
template <>
inline constexpr std::array<std::string_view, 9> choiceNames<JointDrawn>{
    "own", "none", "rope", "cord", "chain", "belt", "rod", "spring", "wire"};

/// A struct of its own, so that the state hash leaves it out: equal worlds may look different.
struct JointLook {
    static constexpr Coverage coverage = leftOut("it is only drawn");
    JointDrawn drawn = JointDrawn::own;
    friend bool operator==(JointLook const&, JointLook const&) = default;
};

} // namespace trembler
