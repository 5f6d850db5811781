#include "game/ui/play/play_screen.hpp"

#include "game/ui/shared/words.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "render/scene/areas.hpp"
#include "runtime/level/read/read_level.hpp"

namespace trembler::ui {
namespace {

constexpr int fastFactor = 4;
constexpr double askSeconds = 4;
constexpr double budgetStep = 1.25; // by which a key makes it more or less
/// Objects are pointed at within this many pixels at UI scale 1.
constexpr double pickReach = 6;

} // namespace

PlayScreen::PlayScreen(UiContext& context, std::filesystem::path file, WorldOptions const& options)
    : context_(context), file_(std::move(file)),
      session_(context.registry, context.parts, loadLevel(context.registry, file_), options),
      placing_(session_, context.toasts), hand_(session_), budget_(context.registry),
      audio_(context.loudspeaker), goals_(session_.level()) {
    state_.names = context.profile.settings().names;
    state_.nextLevel = context.levels.after(file_) != nullptr;
    worldChanged();
    view_.setSubject(subject());
}

PlayScreen::~PlayScreen() {
    audio_.leave();
}

void PlayScreen::worldChanged() {
    scene_.start();
    hovered_ = {};
}

render::Extent PlayScreen::subject() const {
    render::Extent all = render::sceneFocus(session_.world());
    if (session_.level().placing) {
        for (Area const& area : *session_.level().placing) {
            all.add(render::extentOf(area));
        }
    }
    all.add(goals_.extent());
    if (all.empty()) {
        all.add(render::Point{-2, -2});
        all.add(render::Point{2, 2});
    }
    return all.widened(0.06 * render::length(all.half()));
}

Margins PlayScreen::margins() const {
    auto const scale = static_cast<double>(context_.window.uiScale());
    bool const boxed = !session_.level().toolbox.empty();
    return {scale * (goalCardWidth + 2 * cardGap), scale * cardGap,
            scale * (boxed ? toolboxWidth + 2 * cardGap : cardGap), scale * (bottomRow + 6)};
}

PlayRequest PlayScreen::update(double seconds) {
    request_ = PlayRequest::none;
    stepped_ = takenNow_ = false;
    view_.setView(context_.window.size(), margins());
    pointer_ = readPointer();
    askedFor_ += seconds;
    state_.askAllBack = state_.askAllBack && askedFor_ < askSeconds && building();
    drawCards();
    if (!context_.gui.wantsKeyboard()) {
        readKeys();
    }
    useTools(pointer_, seconds);
    lookAround(pointer_);
    advance(seconds);
    state_.celebratedFor += state_.celebrating ? seconds : 0;
    return request_;
}

void PlayScreen::updateBehindMenu() {
    view_.setView(context_.window.size(), margins());
    stepped_ = false;
    placing_.cancel();
}

Pointer PlayScreen::readPointer() {
    auto const& input = context_.input;
    Pointer pointer;
    pointer.screen = input.mouse();
    render::Point const world = camera().toWorld(pointer.screen);
    pointer.world = {world.x, world.y};
    pointer.uiScale = static_cast<double>(context_.window.uiScale());
    pointer.pixel = pointer.uiScale / camera().pixelsPerMetre;
    std::string_view const card = context_.layout.cardAt(pointer.screen);
    pointer.overToolbox = card == "toolbox";
    pointer.overCard = !card.empty() || (context_.gui.wantsMouse() && !placing_.carried() && !hand_.busy());
    pointer.pressed = input.pressed(render::MouseButton::Left);
    pointer.released = input.released(render::MouseButton::Left);
    pointer.held = input.held(render::MouseButton::Left);
    pointer.twice = input.doubleClicked(render::MouseButton::Left);
    pointer.wheel = input.wheel();
    pointer.fine = context_.shiftHeld();
    pointer.free = context_.controlHeld() || context_.altHeld();
    if (input.pressed(render::MouseButton::Right)) {
        rightPressedAt_ = pointer.screen;
    }
    pointer.rightClicked =
        input.released(render::MouseButton::Right) && pointer.strayed(rightPressedAt_) <= dragThreshold;
    return pointer;
}

void PlayScreen::useTools(Pointer const& pointer, double seconds) {
    bool const open = !pointer.overCard && context_.input.mouseInside();
    render::Point const at{pointer.world.x, pointer.world.y};
    hovered_ = open ? render::pick(session_.world(), at, pickReach * pointer.pixel) : ObjectId{};
    if (pointer.pressed) {
        pressedAt_ = pointer.screen;
    }
    if (building()) {
        usePlacing(pointer);
    } else {
        useHand(pointer, seconds);
    }
}

void PlayScreen::usePlacing(Pointer const& pointer) {
    std::optional<int> const number = hovered_.valid() ? session_.numberOf(hovered_) : std::nullopt;
    std::optional<Vec2> const knob = handle();
    bool const onHandle = knob && length(pointer.world - *knob) < 13 * pointer.pixel;
    bool const wasCarrying = placing_.carried().has_value();
    auto const before = session_.placed().size();
    World const* const world = &session_.world();
    if (!takenNow_) {
        placing_.update(pointer, number, onHandle);
    }
    if (world != &session_.world() || before != session_.placed().size()) {
        worldChanged();
        return;
    }
    if (number && pointer.twice && !pointer.overCard) {
        inspect(hovered_);
    }
    bool const paper = !wasCarrying && !number && !onHandle;
    if (pointer.pressed) {
        leftOnPaper_ = paper && !pointer.overCard;
    }
    if (pointer.released && leftOnPaper_) {
        leftOnPaper_ = false;
        if (pointer.strayed(pressedAt_) <= dragThreshold) {
            inspect(hovered_);
        }
    }
}

void PlayScreen::useHand(Pointer const& pointer, double seconds) {
    bool const free = hovered_.valid() && session_.world().find<Fixed>(hovered_) == nullptr;
    if (pointer.pressed) {
        leftOnPaper_ = !pointer.overCard && !hand_.cutting() && (!free || replay_.loaded());
    }
    auto const clicked = hand_.update(pointer, hovered_, seconds);
    if (clicked) {
        inspect(*clicked);
    }
    if (!pointer.held) {
        leftOnPaper_ = false;
    }
    if (pointer.rightClicked && hand_.cutting()) {
        hand_.setCutting(false);
    }
}

void PlayScreen::inspect(ObjectId object) {
    if (object.valid()) {
        inspector_.show(session_.world().store().nameOf(object));
    } else {
        inspector_.close();
    }
}

void PlayScreen::lookAround(Pointer const& pointer) {
    auto const& input = context_.input;
    bool const carrying = placing_.carried().has_value();
    if (pointer.wheel != 0 && !pointer.overCard && !carrying) {
        view_.zoom(pointer.screen, pointer.wheel);
    }
    if (input.pressed(render::MouseButton::Right)) {
        rightOnPaper_ = !pointer.overCard;
    }
    bool const middle = input.held(render::MouseButton::Middle);
    bool const right = input.held(render::MouseButton::Right) && rightOnPaper_;
    bool const left = pointer.held && leftOnPaper_ && !carrying;
    if ((middle && !pointer.overCard) || right || left) {
        view_.startPan();
    } else if (!middle) {
        view_.stopPan();
    }
    view_.drag(input.mouseMoved());
}

bool PlayScreen::fast() const {
    return state_.fast || context_.input.keyHeld(SDLK_TAB);
}

void PlayScreen::advance(double seconds) {
    if (session_.mode() != SessionMode::running) {
        audio_.pause(seconds, camera());
        return;
    }
    // A film has every frame once, however long a picture takes.
    int const due = state_.recording ? 1 : clock_.due(seconds, fast() ? fastFactor : 1);
    for (int i = 0; i < due; ++i) {
        stepOnce();
    }
}

void PlayScreen::stepOnce() {
    if (building()) {
        placing_.reset();
        session_.start();
        audio_.enter(session_.world());
        session_.pause();
        worldChanged();
    }
    if (session_.world().frame() == 0) {
        // All along, not only while they are shown: the overlay is right at once, in a paused world too.
        patches_ = session_.world().want<ContactPatches>();
    }
    hand_.beforeStep();
    replay_.beforeStep(session_);
    budget_.beforeStep(session_, !replay_.loaded()); // what was decided then is being repeated
    scene_.remember(session_.world());
    sounds_.beforeStep(session_.world());
    session_.step();
    sounds_.afterStep(session_.world());
    // In fast motion every fourth frame is heard, at its own pitch.
    if (!fast() || session_.world().frame() % fastFactor == 0) {
        audio_.frame(session_.world(), camera());
    }
    stepped_ = true;
    noteSuccess();
}

void PlayScreen::noteSuccess() {
    if (counted_ || !session_.solved()) {
        return;
    }
    counted_ = true;
    state_.celebrating = true;
    state_.celebratedFor = 0;
    state_.solvedAt = session_.world().time();
    if (CatalogEntry const* const entry = context_.levels.find(file_)) {
        context_.profile.markSolved(entry->id);
    }
}

void PlayScreen::stop() {
    audio_.leave();
    session_.stop();
    hand_.reset();
    replay_.clear();
    clock_.reset();
    counted_ = state_.celebrating = state_.cutting = state_.fast = false;
    state_.solvedAt.reset();
    if (state_.recording) {
        toggleRecording();
    }
    worldChanged();
}

void PlayScreen::runOrStop() {
    if (!building()) {
        stop();
    } else {
        begin(false);
    }
}

void PlayScreen::begin(bool asBefore) {
    placing_.reset();
    clock_.reset();
    if (asBefore) {
        session_.startAgain();
    } else {
        session_.start();
    }
    audio_.enter(session_.world());
    worldChanged();
}

void PlayScreen::watchAgain() {
    std::vector<RecordedInput> inputs(session_.inputs().begin(), session_.inputs().end());
    std::vector<RecordedChange> changes(session_.changes().begin(), session_.changes().end());
    stop();
    begin(true);
    replay_.load(std::move(inputs), std::move(changes));
}

void PlayScreen::restart() {
    stop();
    placing_.reset();
    inspector_.close();
    session_.putAllBack();
    state_.hintsShown = 0;
    worldChanged();
    view_.fit();
}

void PlayScreen::askAllBack() {
    if (!building() || session_.placed().empty()) {
        return;
    }
    if (!state_.askAllBack) {
        state_.askAllBack = true;
        askedFor_ = 0;
        context_.toasts.add(words::allBackAgain, render::ToastKind::News, askSeconds);
        return;
    }
    state_.askAllBack = false;
    placing_.reset();
    session_.putAllBack();
    worldChanged();
    context_.toasts.add(words::allBackDone);
}

void PlayScreen::toggleRecording() {
    auto& recorder = context_.recorder;
    if (state_.recording) {
        recorder.stop();
        state_.recording = false;
        context_.toasts.add(words::recorded(recorder.frames(), recorder.film().string()),
                            render::ToastKind::News, 6);
        return;
    }
    try {
        recorder.start();
        state_.recording = true;
        context_.toasts.add(words::recordingTo(recorder.film().string()), render::ToastKind::News, 5);
    } catch (render::RenderError const& error) {
        context_.toasts.add(error.what(), render::ToastKind::Trouble);
    }
}

void PlayScreen::saveSolution() {
    if (building() || session_.world().frame() == 0) {
        context_.toasts.add(words::runBeforeSaving, render::ToastKind::News, 5);
        return;
    }
    if (auto const whyNot = session_.whyNotRecorded()) {
        context_.toasts.add(*whyNot, render::ToastKind::Trouble, 6);
        return;
    }
    try {
        auto const path =
            context_.recorder.solution(session_.record(words::mySolution), file_.stem().string());
        context_.toasts.add(words::solutionSaved(path.string()), render::ToastKind::News, 6);
    } catch (std::runtime_error const& error) {
        context_.toasts.add(error.what(), render::ToastKind::Trouble, 6);
    }
}

void PlayScreen::takePictures() {
    try {
        if (state_.recording && stepped_) {
            context_.recorder.add(context_.window.readPixels());
        }
        if (wantPicture_) {
            wantPicture_ = false;
            auto const path = context_.recorder.picture(context_.window.readPixels());
            context_.toasts.add(words::pictureTaken(path.string()));
        }
    } catch (render::RenderError const& error) {
        state_.recording = false;
        context_.toasts.add(error.what(), render::ToastKind::Trouble, 6);
    }
}

void PlayScreen::carryOut(Command command) {
    switch (command) {
    case Command::runOrStop:
        return runOrStop();
    case Command::pauseOrGo:
        if (session_.mode() == SessionMode::running) {
            session_.pause();
        } else if (session_.mode() == SessionMode::paused) {
            clock_.reset();
            session_.resume();
        }
        return;
    case Command::step:
        if (session_.mode() == SessionMode::running) {
            session_.pause();
        }
        clock_.reset();
        return stepOnce();
    case Command::fastForward:
        state_.fast = !state_.fast;
        return;
    case Command::undo:
    case Command::redo:
        placing_.cancel();
        if (command == Command::undo ? session_.undo() : session_.redo()) {
            worldChanged();
        }
        return;
    case Command::allBack:
        return askAllBack();
    case Command::electricity:
        state_.electricity = !state_.electricity;
        return;
    case Command::magnetism:
        state_.magnetism = !state_.magnetism;
        return;
    case Command::contacts:
        state_.contacts = !state_.contacts;
        return;
    case Command::names: {
        state_.names = !state_.names;
        Settings settings = context_.profile.settings();
        settings.names = state_.names;
        return context_.profile.setSettings(settings);
    }
    case Command::components:
        components_.toggle();
        state_.components = components_.open();
        return;
    case Command::budget:
        return context_.toasts.add(switchBudget(budget_));
    case Command::lessBudget:
        return context_.toasts.add(changeBudget(budget_, 1 / budgetStep));
    case Command::moreBudget:
        return context_.toasts.add(changeBudget(budget_, budgetStep));
    case Command::cut:
        if (!building()) {
            hand_.setCutting(!hand_.cutting());
        }
        return;
    case Command::record:
        return toggleRecording();
    case Command::picture:
        wantPicture_ = true;
        return;
    case Command::save:
        return saveSolution();
    case Command::fit:
        return view_.fit();
    case Command::hint:
        if (session_.level().hints.empty()) {
            context_.toasts.add(words::noHints);
        }
        state_.hintsShown = std::min(state_.hintsShown + 1, session_.level().hints.size());
        return;
    case Command::inspect:
        if (placing_.selected()) {
            inspect(session_.objectOf(*placing_.selected()));
        } else {
            inspect(hovered_);
        }
        return;
    case Command::menu:
        request_ = PlayRequest::menu;
        return;
    case Command::levels:
        request_ = PlayRequest::levels;
        return;
    case Command::help:
        request_ = PlayRequest::help;
        return;
    case Command::fullscreen:
        request_ = PlayRequest::fullscreen;
        return;
    case Command::nextLevel:
        request_ = PlayRequest::nextLevel;
        return;
    case Command::watchAgain:
        return watchAgain();
    case Command::keepPlaying:
        state_.celebrating = false;
        return;
    }
}

} // namespace trembler::ui
