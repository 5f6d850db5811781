// Small differences pass, differences that a player would notice do not.
#include "tests/game/ui/stored_picture.hpp"

#include <gtest/gtest.h>

namespace trembler::ui::test {
namespace {

using render::Image;

/// A light sheet with a dark rectangle on it.
Image sheet(int left, int top, int width, int height, int dark = 40) {
    Image image({320, 200});
    for (int y = 0; y < 200; ++y) {
        for (int x = 0; x < 320; ++x) {
            bool const on = x >= left && x < left + width && y >= top && y < top + height;
            auto const first = static_cast<std::size_t>(y * 320 + x) * 4;
            for (std::size_t c = 0; c < 3; ++c) {
                image.bytes()[first + c] = static_cast<std::uint8_t>(on ? dark : 230);
            }
            image.bytes()[first + 3] = 255;
        }
    }
    return image;
}

double share(Image const& a, Image const& b) {
    return compare(inBlocks(a), inBlocks(b)).share;
}

TEST(StoredPicture, IsASixteenthAndTellsMeanColours) {
    Image const blocks = inBlocks(sheet(0, 0, 6, 200));
    EXPECT_EQ(blocks.size(), (render::Size{80, 50}));
    EXPECT_EQ(blocks.at(0, 0)[0], 40);
    EXPECT_EQ(blocks.at(1, 0)[0], 136) << "half dark, half light: 135, in steps of 8";
    EXPECT_EQ(blocks.at(2, 0)[0], 232);
}

TEST(StoredPicture, AShiftByAPixelIsNoDifferenceAndOneByTwoBlocksIs) {
    Image const before = sheet(100, 60, 80, 40);
    EXPECT_EQ(share(before, before), 0);
    EXPECT_EQ(share(before, sheet(101, 61, 80, 40)), 0);
    EXPECT_GT(share(before, sheet(109, 60, 80, 40)), shareTolerance);
}

TEST(StoredPicture, SomethingMissingOrOfAnotherColourIsADifference) {
    Image const with = sheet(100, 60, 40, 20);
    Image const without = sheet(0, 0, 0, 0);
    EXPECT_GT(share(with, without), shareTolerance);
    EXPECT_GT(share(without, with), shareTolerance);
    EXPECT_GT(share(with, sheet(100, 60, 40, 20, 80)), shareTolerance);
    EXPECT_EQ(share(with, sheet(100, 60, 40, 20, 46)), 0);
    EXPECT_EQ(
        compare(inBlocks(with, {{{100, 60}, {140, 80}}}), inBlocks(without, {{{100, 60}, {140, 80}}})).share,
        0)
        << "what is ignored may differ";
}

TEST(StoredPicture, PicturesOfDifferentSizesDiffer) {
    EXPECT_EQ(compare(Image({4, 4}), Image({4, 5})).share, 1);
    EXPECT_EQ(beside({Image({4, 4}), Image({5, 4})}).size(), (render::Size{17, 4}));
}

} // namespace
} // namespace trembler::ui::test
