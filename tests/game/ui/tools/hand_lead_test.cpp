// A crank that a hand drags along the handle's own circle.
#include "game/ui/tools/hand_lead.hpp"
#include "physics/dynamics/interactions/from_player.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "tests/game/ui/player.hpp"

#include <cmath>

namespace trembler::ui::test {
namespace hand_lead_test {
namespace {

TEST(HandLead, IsTheWayThatTheHandsSpringStaysBehind) {
    EXPECT_DOUBLE_EQ(HandLead::springDelay, 2 / DynamicsFromPlayer::frequency);
    HandLead lead;
    lead.begin({1, 1});
    constexpr double speed = 1.5; // m/s
    Vec2 pointer{1, 1};
    Vec2 target;
    for (int frame = 0; frame < 20; ++frame) {
        pointer.x += speed * frameDuration;
        target = lead.ahead(pointer);
    }
    EXPECT_NEAR(target.x - pointer.x, speed * HandLead::springDelay, 1e-9);
    EXPECT_EQ(target.y, 1);
    for (int frame = 0; frame < 4; ++frame) {
        target = lead.ahead(pointer);
    }
    EXPECT_EQ(target, pointer) << "it rests";
}

TEST(HandLead, ThrowsNothingWhereThePointerJumps) {
    HandLead lead;
    lead.begin({0, 0});
    for (int frame = 0; frame < 20; ++frame) {
        Vec2 const pointer{frame < 5 ? 0.0 : 2.0, 0};
        EXPECT_EQ(lead.ahead(pointer), pointer) << frame;
    }
    for (int frame = 0; frame < 40; ++frame) {
        Vec2 const pointer{2 + 0.5 * frame, 0};
        EXPECT_LE(length(lead.ahead(pointer) - pointer), HandLead::most + 1e-12) << frame;
    }
}

/// The turns of the crank, and the share of frames in which the generator feeds something, of ten seconds in
/// which a hand drags its handle around at that number of frames a turn.
struct Cranked {
    double turns = 0;
    double on = 0;
};
Cranked crank(int framesPerTurn) {
    Player player({960, 540});
    player.open(levelsFolder() / "5-everything/3-the-quiet-gate.json");
    player.frames(4);
    player.key(SDLK_SPACE);
    constexpr double arm = 0.3; // m
    Vec2 const axle{3.3, 0.41};
    World const& world = player.session().world();
    ObjectId const handle = world.store().find("portable generator crank");
    player.moveTo(player.at(axle - Vec2{0, arm}));
    player.press();
    Cranked cranked;
    constexpr int frames = 600;
    double last = world.find<Rotation>(handle)->angle;
    double const speed = 2 * pi / framesPerTurn;
    for (int frame = 1; frame <= frames; ++frame) {
        double const angle = -pi / 2 + speed * frame;
        player.moveTo(player.at(axle + arm * Vec2{std::cos(angle), std::sin(angle)}));
        double const now = world.find<Rotation>(handle)->angle;
        cranked.turns += std::remainder(now - last, 2 * pi) / (2 * pi);
        last = now;
        cranked.on += std::abs(world.find<AngularVelocity>(handle)->value) > pi / 2 ? 1.0 / frames : 0;
    }
    player.release();
    return cranked;
}

// At a turn a second the handle swung to and fro, and at 75 frames a turn it turned a third of the way.
TEST(HandLead, LetsACrankFollowAHandOnTheHandlesOwnCircle) {
    for (int const framesPerTurn : {60, 75, 120}) {
        Cranked const cranked = crank(framesPerTurn);
        EXPECT_NEAR(cranked.turns, 600.0 / framesPerTurn, 0.5) << framesPerTurn;
        EXPECT_GT(cranked.on, 0.9) << framesPerTurn;
    }
}

} // namespace
} // namespace hand_lead_test
} // namespace trembler::ui::test
