// A part that the designer has made has a picture of what it was made from, at once and in the next session.
#include "tests/game/ui/edit/editor_kit.hpp"

#include <cstdlib>

namespace trembler::ui::test {
namespace own_part_picture_test {
namespace {

/// A red box and a blue disc beside it.
char const* const twoColours = R"({"version": 2, "title": "Two colours",
    "world": {"gravity": [0, -9.81], "bounds": [-4, -0.5, 8, 4.5]},
    "objects": [
        {"name": "red box", "at": [-0.3, 1], "properties": {"material": "wood", "look": {"colour": "#d01818"},
         "shape": [{"form": "box", "width": 0.6, "height": 0.6}]}},
        {"name": "blue disc", "at": [0.3, 1], "properties": {"material": "wood", "look": {"colour": "#1838d0"},
         "shape": [{"form": "circle", "radius": 0.3}]}}],
    "joints": [{"form": "weld", "a": "red box", "b": "blue disc", "at": [0, 1]}]})";

/// The pixels of the part's tile in the catalogue, and its left upper corner on the screen.
std::vector<render::Pixel> tileOf(Designer& designer, std::string const& part, std::string const& picture) {
    designer.key(SDLK_F2);
    designer.frames(2);
    designer.clickItem("search parts");
    designer.ctrl(SDLK_a);
    designer.typeText(part);
    designer.moveTo({20, 700}); // no tile is under the pointer
    designer.frames(3);
    auto const rect = designer.layout().item("part " + part);
    EXPECT_TRUE(rect);
    std::vector<render::Pixel> pixels;
    if (!rect) {
        return pixels;
    }
    render::Image const screen = designer.look(picture);
    for (int y = static_cast<int>(rect->low.y); y < static_cast<int>(rect->high.y); ++y) {
        for (int x = static_cast<int>(rect->low.x); x < static_cast<int>(rect->high.x); ++x) {
            pixels.push_back(screen.at(x, y));
        }
    }
    return pixels;
}

/// The share of the pixels in which one of the channels (0 red, 2 blue) is far above the others.
double shareOf(std::vector<render::Pixel> const& pixels, std::size_t channel) {
    auto const isIt = [&](render::Pixel const& pixel) {
        int const others = std::max<int>(pixel[1], pixel[2 - channel]);
        return pixel[channel] > others + 60;
    };
    return static_cast<double>(std::count_if(pixels.begin(), pixels.end(), isIt)) /
           static_cast<double>(std::max<std::size_t>(pixels.size(), 1));
}

class OwnPart : public testing::Test {
protected:
    OwnPart() {
        std::filesystem::remove_all(folder);
        char const* const stated = std::getenv("XDG_DATA_HOME");
        before = stated == nullptr ? std::optional<std::string>() : std::string(stated);
        ::setenv("XDG_DATA_HOME", folder.c_str(), 1);
    }
    ~OwnPart() override {
        if (before) {
            ::setenv("XDG_DATA_HOME", before->c_str(), 1);
        } else {
            ::unsetenv("XDG_DATA_HOME");
        }
    }
    OwnPart(OwnPart const&) = delete;
    OwnPart& operator=(OwnPart const&) = delete;

    std::filesystem::path const folder = testFolder() / "own parts";
    std::optional<std::string> before;
};

TEST_F(OwnPart, HasAPictureOfItsObjectsAlsoInTheNextSession) {
    std::vector<render::Pixel> first;
    {
        Designer designer;
        designer.editText(twoColours);
        designer.ctrl(SDLK_a);
        designer.key(SDLK_k);
        designer.frames(3);
        ASSERT_TRUE(designer.showsCard("part name"));
        designer.ctrl(SDLK_a);
        designer.typeText("two colours");
        designer.frames(1);
        designer.clickItem("make part");
        designer.frames(12);
        ASSERT_NE(designer.parts().data->parts.find("two colours"), nullptr);
        first = tileOf(designer, "two colours", "own-part-tile");
        EXPECT_GT(shareOf(first, 0), 0.05) << "the red box";
        EXPECT_GT(shareOf(first, 2), 0.04) << "the blue disc";
        std::vector<render::Pixel> const other = tileOf(designer, "steel ball", "another-tile");
        EXPECT_LT(shareOf(other, 0) + shareOf(other, 2), 0.01) << "a tile without these colours";
    }
    Designer again;
    again.editText(twoColours);
    // Only the parts of the new program know its own file.
    GameData const fresh;
    ASSERT_NE(fresh.parts.find("two colours"), nullptr);
    again.app().edit({});
    again.frames(4);
    std::vector<render::Pixel> const second = tileOf(again, "two colours", "own-part-tile-again");
    EXPECT_EQ(second, first);
}

} // namespace
} // namespace own_part_picture_test
} // namespace trembler::ui::test
