#include "render/scene/objects/body.hpp"
#include "render/scene/objects/device.hpp"
#include "tests/render/scene/scene_stage.hpp"

namespace trembler::render::test {
namespace {

Image pictureOf(Facts const& facts) {
    return picture({240, 160}, palette::paper, [&](Canvas& canvas) { drawObject(canvas, facts, {}); });
}

TEST(Device, StatedAsPlainIsDrawnAsItsBodyAlone) {
    Shape const plate{{boxPiece(1, 0.6)}};
    Facts body;
    body.shape = &plate;
    body.substance = Substance::plastic;
    Facts device = body;
    device.device = true;
    device.conductor = true;
    EXPECT_FALSE(pictureOf(device) == pictureOf(body)) << "the sign of a device";
    device.form = LookForm::plain;
    EXPECT_TRUE(pictureOf(device) == pictureOf(body));
}

TEST(Device, StatedAsABulbIsDrawnAsOneForAnyMaterial) {
    Shape const lamp{{circlePiece(0.4), boxPiece(0.3, 0.3, {0, -0.5})}};
    Facts glass;
    glass.shape = &lamp;
    glass.substance = Substance::glass;
    glass.device = true;
    glass.conductor = true;
    Facts plastic = glass;
    plastic.substance = Substance::plastic;
    EXPECT_FALSE(pictureOf(plastic) == pictureOf(glass));
    plastic.form = LookForm::bulb;
    EXPECT_TRUE(pictureOf(plastic) == pictureOf(glass));
    plastic.device = false; // a bulb outside of any circuit looks like one that is off
    EXPECT_TRUE(pictureOf(plastic) == pictureOf(glass));
}

// The flash was seen through the letter.
TEST(Device, WithALabelHasABlankDiscUnderIt) {
    Shape const wheel{{circlePiece(0.4)}};
    Facts device;
    device.shape = &wheel;
    device.substance = Substance::copper;
    device.device = true;
    device.conductor = true;
    Look const letter{.label = "M"};
    Facts named = device;
    named.look = &letter; // the label itself is drawn later, with all words
    auto const middleIsPlain = [](Image const& image) {
        for (int y = 74; y <= 86; ++y) { // a part of the disc
            for (int x = 114; x <= 126; ++x) {
                if (image.at(x, y) != image.at(120, 80)) {
                    return false;
                }
            }
        }
        return true;
    };
    EXPECT_FALSE(middleIsPlain(pictureOf(device))) << "the flash";
    EXPECT_TRUE(middleIsPlain(pictureOf(named)));
}

} // namespace
} // namespace trembler::render::test
