// Every part on its tile of the toolbox: large enough, and not to be taken for another part.
#include "render/draw/palette.hpp"
#include "render/scene/objects/part.hpp"
#include "runtime/level/read/read_part.hpp"
#include "tests/render/scene/scene_stage.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace trembler::render::test {
namespace {

constexpr int tilePixels = 80;
constexpr Size tileSize{tilePixels, tilePixels};

PartLibrary const& partsOfTheGame() {
    static PartLibrary const library =
        loadParts(everything(), std::filesystem::path(TREMBLER_SOURCE_DIR) / "assets" / "parts");
    return library;
}

/// As PartCatalog draws it, without shadows.
Image tileOf(PartLibrary const& library, std::string const& part) {
    Placement const placement = placementOnTile(library, part);
    Extent const extent = extentOnTile(library, placement);
    Camera camera{{}, 100, tileSize};
    camera.fit(extent.lower, extent.upper, 0.10 * tilePixels);
    return picture(
        tileSize, palette::paperLight, [&](Canvas& canvas) { drawPartOnTile(canvas, library, placement); },
        {.shadows = false}, camera);
}

/// Whether two colours are different at a glance.
bool differ(Pixel const& a, Pixel const& b) {
    constexpr int step = 30; // of 255
    return std::abs(a[0] - b[0]) > step || std::abs(a[1] - b[1]) > step || std::abs(a[2] - b[2]) > step;
}

Pixel ground() {
    Colour const paper = palette::paperLight;
    return {paper.red, paper.green, paper.blue, 255};
}

/// How many of the pixels that either picture paints are different, 0 to 1.
double shareOfDifference(Image const& a, Image const& b) {
    int painted = 0;
    int different = 0;
    for (int y = 0; y < tilePixels; ++y) {
        for (int x = 0; x < tilePixels; ++x) {
            Pixel const first = a.at(x, y);
            Pixel const second = b.at(x, y);
            painted += differ(first, ground()) || differ(second, ground()) ? 1 : 0;
            different += differ(first, second) ? 1 : 0;
        }
    }
    return painted == 0 ? 0 : static_cast<double>(different) / painted;
}

TEST(Tiles, AreFilledByTheirParts) {
    PartLibrary const& library = partsOfTheGame();
    for (std::string const& name : library.names()) {
        Image const tile = tileOf(library, name);
        int left = tilePixels;
        int right = 0;
        int top = tilePixels;
        int bottom = 0;
        for (int y = 0; y < tilePixels; ++y) {
            for (int x = 0; x < tilePixels; ++x) {
                if (differ(tile.at(x, y), ground())) {
                    left = std::min(left, x);
                    right = std::max(right, x);
                    top = std::min(top, y);
                    bottom = std::max(bottom, y);
                }
            }
        }
        // 80 % of the tile is the aim; a part whose signs or ropes move a little may leave some of it.
        EXPECT_GE(std::max(right - left, bottom - top), 0.7 * tilePixels) << name;
        EXPECT_LE(std::abs(left + right - tilePixels), 0.15 * tilePixels) << name << " is not in the middle";
        EXPECT_LE(std::abs(top + bottom - tilePixels), 0.15 * tilePixels) << name << " is not in the middle";
    }
}

TEST(Tiles, ShowNoTwoPartsAlike) {
    PartLibrary const& library = partsOfTheGame();
    std::vector<std::string> const names = library.names();
    std::vector<Image> tiles;
    for (std::string const& name : names) {
        tiles.push_back(tileOf(library, name));
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_GT(shareOfDifference(tiles[i], tiles[j]), 0.2) << names[i] << " looks like " << names[j];
        }
    }
}

TEST(Tiles, ShowLongLooseThingsDiagonally) {
    PartLibrary const& library = partsOfTheGame();
    for (char const* const loose : {"steel bar", "plank", "spanner"}) {
        EXPECT_GT(placementOnTile(library, loose).angle, 0.3) << loose;
    }
    // Fixed, upright, or of several pieces.
    for (char const* const straight :
         {"shelf", "shallow ramp", "glass pane", "domino", "seesaw", "nothing"}) {
        EXPECT_EQ(placementOnTile(library, straight).angle, 0) << straight;
    }
}

} // namespace
} // namespace trembler::render::test
