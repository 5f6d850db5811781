#include "tests/game/ui/stored_picture.hpp"

#include <algorithm>
#include <array>

namespace trembler::ui::test {
namespace {

using render::Image;
using render::Pixel;

void put(Image& image, int x, int y, Pixel const& pixel) {
    auto const first = (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.size().width) +
                        static_cast<std::size_t>(x)) *
                       4;
    std::copy(pixel.begin(), pixel.end(), image.bytes().begin() + static_cast<std::ptrdiff_t>(first));
}

Pixel meanOf(Image const& screen, int blockX, int blockY) {
    std::array<int, 3> sums{};
    for (int y = blockY * blockSide; y < (blockY + 1) * blockSide; ++y) {
        for (int x = blockX * blockSide; x < (blockX + 1) * blockSide; ++x) {
            Pixel const pixel = screen.at(x, y);
            for (std::size_t c = 0; c < sums.size(); ++c) {
                sums[c] += pixel[c];
            }
        }
    }
    Pixel mean{0, 0, 0, 255};
    for (std::size_t c = 0; c < sums.size(); ++c) {
        int const exact = sums[c] / (blockSide * blockSide);
        mean[c] = static_cast<std::uint8_t>(std::min(8 * ((exact + 4) / 8), 255));
    }
    return mean;
}

/// Whether a block's colour is, give or take the tolerance, between those around its place in the other
/// picture.
bool isAround(Pixel const& pixel, Image const& other, int x, int y) {
    auto const [width, height] = other.size();
    for (std::size_t c = 0; c < 3; ++c) {
        int least = 255;
        int most = 0;
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v) {
            for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u) {
                least = std::min<int>(least, other.at(u, v)[c]);
                most = std::max<int>(most, other.at(u, v)[c]);
            }
        }
        if (pixel[c] < least - blockTolerance || pixel[c] > most + blockTolerance) {
            return false;
        }
    }
    return true;
}

} // namespace

Image inBlocks(Image const& screen, std::vector<Ignored> const& ignored) {
    Image blocks({screen.size().width / blockSide, screen.size().height / blockSide});
    auto const [width, height] = blocks.size();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            bool const left = std::any_of(ignored.begin(), ignored.end(), [&](Ignored const& part) {
                return (x + 1) * blockSide > part.low.x && x * blockSide < part.high.x &&
                       (y + 1) * blockSide > part.low.y && y * blockSide < part.high.y;
            });
            put(blocks, x, y, left ? Pixel{128, 128, 128, 255} : meanOf(screen, x, y));
        }
    }
    return blocks;
}

Comparison compare(Image const& expected, Image const& got) {
    if (expected.size() != got.size()) {
        return {1, got};
    }
    Comparison result{0, Image(got.size())};
    auto const [width, height] = got.size();
    int differ = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            // Both ways: a missing item differs from everything around its place, too. Equal blocks are
            // around each other, and nearly all are equal.
            Pixel const pixel = got.at(x, y);
            Pixel const stored = expected.at(x, y);
            bool const same =
                pixel == stored || (isAround(pixel, expected, x, y) && isAround(stored, got, x, y));
            auto const grey = static_cast<std::uint8_t>((pixel[0] + pixel[1] + pixel[2]) / 6 + 127);
            put(result.difference, x, y, same ? Pixel{grey, grey, grey, 255} : Pixel{220, 0, 0, 255});
            differ += same ? 0 : 1;
        }
    }
    result.share = width * height == 0 ? 0 : static_cast<double>(differ) / (width * height);
    return result;
}

Image beside(std::vector<Image> const& pictures) {
    constexpr int gap = 8;
    render::Size size{-gap, 0};
    for (Image const& picture : pictures) {
        size.width += picture.size().width + gap;
        size.height = std::max(size.height, picture.size().height);
    }
    Image all({std::max(size.width, 0), size.height});
    int left = 0;
    for (Image const& picture : pictures) {
        for (int y = 0; y < picture.size().height; ++y) {
            for (int x = 0; x < picture.size().width; ++x) {
                put(all, left + x, y, picture.at(x, y));
            }
        }
        left += picture.size().width + gap;
    }
    return all;
}

} // namespace trembler::ui::test
