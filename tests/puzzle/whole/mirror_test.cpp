// The mirror image of a world moves as the mirror image of its motion.
#include "runtime/placement.hpp"
#include "tests/puzzle/whole/swing.hpp"

#include <fmt/format.h>
#include <rapidcheck.h>

#include <cmath>

namespace trembler {
namespace {

class Mirror : public WithSwing {
protected:
    /// A scene, or its mirror image about x = 0. The numbers are random.
    struct Scene {
        double x = 0;
        double angle = 0;
        double speed = 0;
        double spin = 0;
        bool swingFlipped = false;
        bool wedgeFlipped = false;
    };
    [[nodiscard]] static LevelFile build(Scene const& scene, bool image) {
        double const s = image ? -1 : 1;
        std::string const objects = fmt::format(
            R"({{"name": "swing", "part": "swing", "at": [{}, 1.5], "angle_deg": {}, "flipped": {}}},
               {{"name": "wedge", "at": [{}, 3.5], "angle_deg": {}, "flipped": {},
                 "properties": {{"material": "wood", "velocity": [{}, 0], "angular_velocity_deg": {},
                   "shape": [{{"form": "polygon", "corners": [[-0.2, -0.1], [0.4, -0.1], [-0.2, 0.2]]}},
                             {{"form": "box", "width": 0.1, "height": 0.3, "at": [-0.2, 0.1], "angle_deg": 10}}]}}}},
               {{"name": "ball", "part": "steel ball", "at": [{}, 3], "properties": {{"velocity": [{}, 1]}}}})",
            s * scene.x, s * scene.angle, scene.swingFlipped != image, s * (scene.x + 2.5), s * scene.angle,
            scene.wedgeFlipped != image,
            // A flipped object's velocity is mirrored with it.
            (scene.wedgeFlipped ? -1 : 1) * scene.speed, (scene.wedgeFlipped ? -1 : 1) * scene.spin,
            s * (scene.x - 2), s * scene.speed);
        return level(objects);
    }
    static double angleOf(Session const& session, ObjectId id) {
        Rotation const* const rotation = session.world().find<Rotation>(id);
        return rotation == nullptr ? 0 : rotation->angle;
    }
};

TEST_F(Mirror, MovesAsTheImage) {
    EXPECT_TRUE(rc::check("random scenes", [&] {
        auto const number = [](int most) { return *rc::gen::inRange(-1000, 1001) * most / 1000.0; };
        Scene const scene{number(1),
                          number(40),
                          number(2),
                          number(90),
                          *rc::gen::arbitrary<bool>(),
                          *rc::gen::arbitrary<bool>()};
        auto const direct = open(build(scene, false));
        auto const image = open(build(scene, true));
        for (int frame = 0; frame <= 40; ++frame) {
            for (char const* const name : {"swing arm", "swing slide", "swing post", "wedge", "ball"}) {
                ObjectId const a = direct->world().store().find(name);
                ObjectId const b = image->world().store().find(name);
                Vec2 const at = direct->world().find<Position>(a)->value;
                Vec2 const mirrored = image->world().find<Position>(b)->value;
                RC_ASSERT(std::abs(at.x + mirrored.x) < 0.01);
                RC_ASSERT(std::abs(at.y - mirrored.y) < 0.01);
                RC_ASSERT(std::abs(angleOf(*direct, a) + angleOf(*image, b)) < 0.02);
            }
            direct->step();
            image->step();
        }
    }));
}

TEST_F(Mirror, FlippedPartsFlippedAgainAreTheSameBits) {
    // A composite that consists of a flipped swing, itself flipped, is a swing.
    PartLibrary const plain = parts;
    parts.add(
        part(R"({"name": "mirrored swing", "objects": [{"name": "x", "part": "swing", "flipped": true}]})"));
    auto const twice =
        open(level(R"({"name": "s", "part": "mirrored swing", "at": [1, 1.5], "flipped": true})"));
    auto const never = open(level(R"({"name": "s", "part": "swing", "at": [1, 1.5]})"));
    for (int frame = 0; frame < 60; ++frame) {
        for (char const* const piece : {"arm", "slide"}) {
            Vec2 const a = twice->world()
                               .find<Position>(twice->world().store().find(std::string("s x ") + piece))
                               ->value;
            Vec2 const b =
                never->world().find<Position>(never->world().store().find(std::string("s ") + piece))->value;
            ASSERT_EQ(a, b) << piece << " in frame " << frame;
        }
        twice->step();
        never->step();
    }
}

} // namespace
} // namespace trembler
