#include "game/ui/play/play_screen.hpp"

#include "game/ui/cards/play_cards.hpp"
#include "game/ui/commands/carry_out_keys.hpp"
#include "game/ui/play/all_cards.hpp"
#include "game/ui/play/commands/play_commands.hpp"
#include "game/ui/play/field_drawing.hpp"

namespace trembler::ui {

PlayScreen::PlayScreen(UiContext& context, std::filesystem::path file, std::shared_ptr<GameData const> data,
                       WorldOptions const& options, LevelFile const* stated)
    : parts_(context, std::move(file), std::move(data), options, stated), commands_(playCommands(), parts_) {}

std::span<Gesture const> PlayScreen::gestures() const {
    return playGestures();
}

void PlayScreen::setView() {
    auto const scale = static_cast<double>(parts_.context.window.uiScale());
    bool const boxed = !parts_.session.level().toolbox.empty();
    Margins const margins{scale * (goalCardWidth + 2 * cardGap), scale * cardGap,
                          scale * (boxed ? toolboxWidth + 2 * cardGap : cardGap), scale * (bottomRow + 6)};
    parts_.view.setView(parts_.context.window.size(), margins);
}

std::optional<ScreenRequest> PlayScreen::update(double seconds) {
    UiContext& context = parts_.context;
    parts_.request.reset();
    parts_.passMods(seconds);
    parts_.run.beginPicture(isHeld(context.input, context.keys, "fast"));
    setView();
    parts_.pointer =
        reader_.read(context, parts_.camera(), parts_.placing.carried().has_value() || parts_.hand.busy());
    parts_.allBack.pass(seconds);
    if (!parts_.run.building()) {
        parts_.allBack.forget();
    }
    if (auto const asked = drawPlayCards(parts_, commands_)) {
        commands_.run(*asked);
    }
    if (!context.gui.wantsKeyboard()) {
        carryOutKeys(context.input.events(), context.keys, commands_);
    }
    auto const handle = parts_.handle();
    FieldMouse::Surroundings const around{handle ? std::optional(handle->at) : std::nullopt,
                                          parts_.run.watching()};
    if (parts_.mouse.update(parts_.pointer, around, seconds)) {
        parts_.newWorld();
    }
    parts_.run.advance(seconds, parts_.film.recording());
    parts_.celebration.pass(seconds);
    return parts_.request;
}

void PlayScreen::updateBehindMenu(double) {
    setView();
    parts_.run.beginPicture(false);
    parts_.placing.cancel();
}

bool PlayScreen::keepsPicture() const {
    return parts_.film.wants(parts_.run.stepped());
}

void PlayScreen::draw() {
    drawField(parts_);
}

void PlayScreen::pictureComplete() {
    parts_.film.take([this] { return parts_.context.window.readPixels(); }, parts_.run.stepped());
}

void PlayScreen::leave() {
    parts_.audio.leave();
    parts_.film.end();
}

std::optional<Vec2> PlayScreen::handle() {
    auto const found = parts_.handle();
    return found ? std::optional(found->at) : std::nullopt;
}

} // namespace trembler::ui
