// Pictures of whole screens, compared with small stored ones.
//
// A stored picture has one pixel for each block of 4 x 4 of a screen's: its mean colour, with 5 bits for each
// of red, green and blue, so that all screens together are a few hundred kilobytes. Letters that another
// version of the graphics driver or of the font library draws a little different, or a pixel further, do not
// change it by more than the tolerance; a button that is missing, moved by more than its own rim, or drawn in
// another colour does.
#pragma once

#include "render/draw/geometry.hpp"
#include "render/gl/image.hpp"

#include <string>
#include <vector>

namespace trembler::ui::test {

/// Pixels of a screen along each side of a block.
inline constexpr int blockSide = 4;
/// A block differs if its red, green or blue is further than this outside of the range of the nine blocks
/// around its place in the other picture; steps of 255.
inline constexpr int blockTolerance = 20;
/// Pictures differ if more than this share of their blocks differ.
inline constexpr double shareTolerance = 0.002;

/// A part of a picture, in pixels of the screen, that is not compared.
struct Ignored {
    render::Point low;
    render::Point high;
};

/// The mean colour of each block, in steps of 8, opaque. Pixels at the right and the bottom that fill no
/// block are left out.
[[nodiscard]] render::Image inBlocks(render::Image const& screen, std::vector<Ignored> const& ignored = {});

struct Comparison {
    double share = 0;           ///< of the blocks that differ, 0 to 1
    render::Image difference{}; ///< the second picture in grey, blocks that differ in red
    [[nodiscard]] bool same() const { return share <= shareTolerance; }
};

/// Two pictures of blocks; of different sizes all blocks differ.
[[nodiscard]] Comparison compare(render::Image const& expected, render::Image const& got);

/// Pictures side by side with a gap, for people; of one height.
[[nodiscard]] render::Image beside(std::vector<render::Image> const& pictures);

} // namespace trembler::ui::test
