// Keys of the play screen; what they are called stands in words.hpp.
#include "game/ui/play/play_screen.hpp"

#include <array>

namespace trembler::ui {
namespace {

struct Key {
    SDL_Keycode key;
    Command command;
};

constexpr std::array keys{
    Key{SDLK_SPACE, Command::runOrStop},   Key{SDLK_p, Command::pauseOrGo},
    Key{SDLK_1, Command::electricity},     Key{SDLK_2, Command::magnetism},
    Key{SDLK_3, Command::contacts},        Key{SDLK_n, Command::names},
    Key{SDLK_c, Command::components},      Key{SDLK_F3, Command::components},
    Key{SDLK_b, Command::budget},          Key{SDLK_COMMA, Command::lessBudget},
    Key{SDLK_PERIOD, Command::moreBudget}, Key{SDLK_x, Command::cut},
    Key{SDLK_r, Command::record},          Key{SDLK_F12, Command::picture},
    Key{SDLK_HOME, Command::fit},          Key{SDLK_h, Command::hint},
    Key{SDLK_i, Command::inspect},         Key{SDLK_l, Command::levels},
    Key{SDLK_F1, Command::help},           Key{SDLK_F11, Command::fullscreen},
    Key{SDLK_BACKSPACE, Command::allBack},
};

} // namespace

void PlayScreen::readControlKeys() {
    auto const& input = context_.input;
    if (input.keyPressed(SDLK_z, true)) {
        carryOut(context_.shiftHeld() ? Command::redo : Command::undo);
    }
    if (input.keyPressed(SDLK_y, true)) {
        carryOut(Command::redo);
    }
    if (input.keyPressed(SDLK_s)) {
        carryOut(Command::save);
    }
}

void PlayScreen::readBuildingKeys() {
    auto const& input = context_.input;
    bool const fine = context_.shiftHeld();
    World const* const world = &session_.world();
    if (input.keyPressed(SDLK_q, true)) {
        placing_.turn(1, fine);
    }
    if (input.keyPressed(SDLK_e, true)) {
        placing_.turn(-1, fine);
    }
    if (input.keyPressed(SDLK_DELETE)) {
        placing_.putBack();
    }
    Vec2 nudge;
    nudge.x += (input.keyPressed(SDLK_RIGHT, true) ? 1 : 0) - (input.keyPressed(SDLK_LEFT, true) ? 1 : 0);
    nudge.y += (input.keyPressed(SDLK_UP, true) ? 1 : 0) - (input.keyPressed(SDLK_DOWN, true) ? 1 : 0);
    if (lengthSquared(nudge) > 0) {
        placing_.nudge(nudge, fine);
    }
    if (world != &session_.world()) {
        worldChanged();
    }
}

void PlayScreen::readKeys() {
    auto const& input = context_.input;
    if (input.keyPressed(SDLK_ESCAPE)) {
        if (hand_.cutting()) {
            hand_.setCutting(false);
        } else if (placing_.cancel()) {
            return;
        } else if (inspector_.open()) {
            inspector_.close();
        } else {
            carryOut(Command::menu);
        }
        return;
    }
    if (context_.controlHeld()) {
        return readControlKeys();
    }
    for (Key const& key : keys) {
        if (input.keyPressed(key.key)) {
            carryOut(key.command);
        }
    }
    if (input.keyPressed(SDLK_f, true)) { // held: slow motion
        carryOut(Command::step);
    }
    if (building()) {
        readBuildingKeys();
    }
}

} // namespace trembler::ui
