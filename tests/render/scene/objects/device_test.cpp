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

} // namespace
} // namespace trembler::render::test
