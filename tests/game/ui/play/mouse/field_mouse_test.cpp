// The mouse on the field without a window: pointing, clicking, dragging and moving the view.
#include "game/ui/play/mouse/field_mouse.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/placement.hpp"
#include "tests/game/ui/player.hpp"

namespace trembler::ui::test {
namespace {

class MouseOnTheField : public testing::Test {
protected:
    explicit MouseOnTheField(char const* level = "experiments/1-switched-electromagnet.json")
        : session(gameData().registry, gameData().parts,
                  loadLevel(gameData().registry, levelsFolder() / level)) {
        view.setSubject(render::sceneFocus(session.world()));
        view.setView({1280, 720}, {});
    }

    /// The mouse at a place of the world.
    [[nodiscard]] Pointer at(Vec2 place) const {
        Pointer pointer;
        pointer.world = place;
        pointer.screen = view.camera().toScreen({place.x, place.y});
        pointer.pixel = 1 / view.camera().pixelsPerMetre;
        return pointer;
    }
    bool update(Pointer const& pointer, bool watching = false) {
        return mouse.update(pointer, {.handle = {}, .watching = watching}, 1.0 / 60);
    }
    bool press(Vec2 place, bool watching = false) {
        Pointer pointer = at(place);
        pointer.pressed = pointer.held = true;
        return update(pointer, watching);
    }
    bool release(Vec2 place) {
        Pointer pointer = at(place);
        pointer.released = true;
        return update(pointer);
    }
    void move(Vec2 place, render::Point pixels, bool watching = false) {
        Pointer pointer = at(place);
        pointer.held = true;
        pointer.moved = pixels;
        update(pointer, watching);
    }
    [[nodiscard]] Vec2 placeOf(char const* object) const {
        return session.world().find<Position>(session.world().store().find(object))->value;
    }

    Session session;
    render::Toasts toasts;
    PlacingTool placing{session, toasts};
    HandTool hand{session, toasts};
    HandTool second{session, toasts, 1};
    CameraControl view;
    Inspector inspector;
    Picking picking{session, inspector};
    GroupTool group{session, placing, toasts};
    WireTool wires{session, toasts};
    FieldMouse mouse{session, placing, group, wires, hand, second, view, picking};
};

TEST_F(MouseOnTheField, PointsAtObjectsThatNoCardCovers) {
    Vec2 const magnet = placeOf("electromagnet");
    update(at(magnet));
    EXPECT_EQ(picking.hovered(), session.world().store().find("electromagnet"));
    Pointer covered = at(magnet);
    covered.overCard = true;
    update(covered);
    EXPECT_FALSE(picking.hovered().valid());
    Pointer outside = at(magnet);
    outside.inside = false;
    update(outside);
    EXPECT_FALSE(picking.hovered().valid());
    update(at(magnet));
    picking.forget();
    EXPECT_FALSE(picking.hovered().valid());
}

TEST_F(MouseOnTheField, AClickInspectsAndAClickBesideClosesTheInspector) {
    Vec2 const magnet = placeOf("electromagnet");
    EXPECT_FALSE(press(magnet));
    EXPECT_FALSE(release(magnet));
    EXPECT_EQ(inspector.name(), "electromagnet");
    press({40, 40});
    release({40, 40});
    EXPECT_FALSE(inspector.open());
}

TEST_F(MouseOnTheField, DraggingThePaperMovesItAndInspectsNothing) {
    auto const before = view.camera().centre;
    press({0.5, 3.4});
    move({0.6, 3.4}, {60, 0});
    release({0.6, 3.4});
    EXPECT_NEAR(view.camera().centre.x, before.x - 60 / view.camera().pixelsPerMetre, 1e-9);
    EXPECT_FALSE(inspector.open());
}

TEST_F(MouseOnTheField, TheWheelZoomsUnlessAPartIsHeldOrACardIsUnderTheMouse) {
    double const scale = view.camera().pixelsPerMetre;
    Pointer pointer = at({0, 1});
    pointer.wheel = 1;
    pointer.overCard = true;
    update(pointer);
    EXPECT_EQ(view.camera().pixelsPerMetre, scale);
    pointer.overCard = false;
    update(pointer);
    EXPECT_GT(view.camera().pixelsPerMetre, scale);
}

TEST_F(MouseOnTheField, AnObjectIsGrabbedExceptDuringAReplay) {
    session.start();
    session.step();
    Vec2 const lever = placeOf("switch");
    press(lever);
    for (int i = 1; i <= 4; ++i) {
        move(lever + Vec2{0, 0.1 * i}, {0, -10});
    }
    EXPECT_EQ(hand.held(), session.world().store().find("switch"));
    release(lever);
    EXPECT_FALSE(hand.held().valid());
    // During a replay, the same drag moves the view.
    auto const before = view.camera().centre;
    press(lever, true);
    move(lever + Vec2{0, 0.1}, {0, -10}, true);
    EXPECT_NE(view.camera().centre, before);
}

class MouseWithoutStrength : public MouseOnTheField {
protected:
    MouseWithoutStrength() : MouseOnTheField("first/2-into-the-basket.json") {}
};

TEST_F(MouseWithoutStrength, GrabsNothingAndSaysSo) {
    session.start();
    session.step();
    Vec2 const ball = placeOf("ball");
    press(ball);
    EXPECT_EQ(toasts.count(), 0U) << "a click inspects, as ever";
    for (int i = 1; i <= 4; ++i) {
        move(ball + Vec2{0, 0.1 * i}, {0, -10});
    }
    EXPECT_EQ(toasts.troubles(), 1U) << "once for each drag";
    EXPECT_FALSE(hand.held().valid());
    hand.beforeStep();
    EXPECT_TRUE(session.inputs().empty());
    release(ball);
    press(ball);
    release(ball);
    EXPECT_EQ(inspector.name(), "ball");
}

} // namespace
} // namespace trembler::ui::test
