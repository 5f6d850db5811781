#include "game/ui/play/mouse/pointer_reader.hpp"

namespace trembler::ui {

Pointer PointerReader::read(UiContext const& context, render::Camera const& camera, bool busy) {
    using render::MouseButton;
    auto const& input = context.input;
    Pointer pointer;
    pointer.screen = input.mouse();
    render::Point const world = camera.toWorld(pointer.screen);
    pointer.world = {world.x, world.y};
    pointer.uiScale = static_cast<double>(context.window.uiScale());
    pointer.pixel = pointer.uiScale / camera.pixelsPerMetre;
    std::string_view const card = context.layout.cardAt(pointer.screen);
    pointer.overToolbox = card == "toolbox";
    pointer.overCard = !card.empty() || (context.gui.wantsMouse() && !busy);
    pointer.inside = input.mouseInside();
    pointer.moved = input.mouseMoved();
    pointer.pressed = input.pressed(MouseButton::Left);
    pointer.released = input.released(MouseButton::Left);
    pointer.held = input.held(MouseButton::Left);
    pointer.twice = input.doubleClicked(MouseButton::Left);
    pointer.wheel = input.wheel();
    pointer.fine = context.shiftHeld();
    pointer.free = context.controlHeld() || context.altHeld();
    pointer.rightPressed = input.pressed(MouseButton::Right);
    pointer.rightHeld = input.held(MouseButton::Right);
    pointer.middleHeld = input.held(MouseButton::Middle);
    if (pointer.rightPressed) {
        rightPressedAt_ = pointer.screen;
    }
    pointer.rightClicked =
        input.released(MouseButton::Right) && pointer.strayed(rightPressedAt_) <= dragThreshold;
    return pointer;
}

} // namespace trembler::ui
