// Several joints between the same two bodies share their load.
#include "tests/physics/dynamics/scene.hpp"

#include <gtest/gtest.h>

namespace trembler::test {
namespace {

struct Swing {
    Vec2 at;
    double angle = 0;
    double apart = 0; ///< m, between the two halves of the pin
};

/// Two rods under a pin of the world, joined by many hinges in one place, swing for some frames.
Swing swing(int hinges, int frames) {
    Scene scene;
    ObjectId const upper = scene.body("upper", boxPiece(1, 0.1), {0.5, 0});
    ObjectId const lower = scene.body("lower", boxPiece(1, 0.1), {1.5, 0});
    Joint pin;
    pin.form = JointForm::hinge;
    pin.a = upper;
    pin.at = {0, 0};
    scene.joint("pin", pin);
    pin.b = lower;
    pin.at = {1, 0};
    for (int i = 0; i < hinges; ++i) {
        scene.joint("tie " + std::to_string(i), pin);
    }
    scene.run(frames);
    auto const end = [&](ObjectId id, double x) { return scene.at(id) + rotated({x, 0}, scene.angle(id)); };
    return {scene.at(lower), scene.angle(lower), length(end(upper, 0.5) - end(lower, -0.5))};
}

TEST(ParallelJoints, SwingAsOneJointDoes) {
    Swing const one = swing(1, 30);
    EXPECT_LT(one.apart, 1e-3);
    for (int const hinges : {2, 20, 300}) {
        Swing const many = swing(hinges, 30);
        EXPECT_LT(length(many.at - one.at), 0.02) << hinges;
        EXPECT_LT(many.apart, 5e-3) << hinges;
    }
}

// The equations of so many joints between two bodies would be a dense matrix of 800 MB, which takes minutes
// to factorise.
TEST(ParallelJoints, FiveThousandStillWork) {
    Swing const one = swing(1, 3);
    Swing const many = swing(5000, 3);
    EXPECT_LT(length(many.at - one.at), 0.02);
    EXPECT_LT(many.apart, 5e-3);
}

} // namespace
} // namespace trembler::test
