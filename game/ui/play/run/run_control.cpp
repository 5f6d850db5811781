#include "game/ui/play/run/run_control.hpp"

#include "physics/dynamics/properties/contacts.hpp"
#include "runtime/input/input_resolver.hpp"

#include <algorithm>
#include <utility>

namespace trembler::ui {
namespace {

/// In one picture, while a run is computed again. What the world becomes does not depend on it.
constexpr int framesAtOnce = 120;

void emptyHands(Session& session) {
    World const& world = session.world();
    Hand const* const first = world.find<Hand>();
    SecondHand const* const second = world.find<SecondHand>();
    for (auto const& [hand, number] :
         {std::pair<Hand const*, int>{first, 0}, {second == nullptr ? nullptr : &second->grip, 1}}) {
        if (hand != nullptr && hand->object.valid()) {
            session.feed({PlayerInput::Kind::release,
                          hand->object,
                          {},
                          hand->target,
                          static_cast<std::uint8_t>(number)});
        }
    }
}

} // namespace

RunControl::RunControl(Session& session, PlacingTool& placing, HandTool& hand, budget::BudgetMode& budget,
                       LevelAudio& audio, CameraControl const& view, RunEvents events)
    : session_(session), placing_(placing), hand_(hand), budget_(budget), audio_(audio), view_(view),
      events_(std::move(events)) {}

void RunControl::beginPicture(bool fastHeld) {
    speed_.holdFast(fastHeld);
    stepped_ = false;
}

void RunControl::advance(double seconds, bool oneFrame) {
    oneFrame_ = oneFrame;
    if (target_) {
        catchUp();
        return;
    }
    if (!running()) {
        audio_.pause(seconds, view_.camera());
        return;
    }
    int const due = oneFrame ? 1 : speed_.due(seconds);
    for (int i = 0; i < due; ++i) {
        stepOnce();
    }
    if (!oneFrame && speed_.now() < 1) { // between the frames of slow motion sounds ring on
        audio_.pause(seconds * (1 - speed_.now()), view_.camera());
    }
}

void RunControl::catchUp() {
    for (int i = 0; i < framesAtOnce && session_.world().frame() < *target_; ++i) {
        stepOnce(false);
    }
    if (session_.world().frame() >= *target_) {
        target_.reset();
        session_.takeOver();
        emptyHands(session_); // the objects that they held then are not held now
        speed_.reset();
    }
}

void RunControl::stepOnce(bool heard) {
    if (building()) {
        placing_.reset();
        session_.start();
        audio_.enter(session_.world());
        session_.pause();
        events_.newWorld();
    }
    if (session_.world().frame() == 0) {
        // During the whole run, not only while contacts are shown: so the overlay is right as soon as it is
        // switched on, in a paused world too.
        patches_ = session_.world().want<ContactPatches>();
    }
    hand_.beforeStep();
    budget_.beforeStep(session_, !watching()); // a run that is watched again repeats its decisions
    events_.beforeStep();
    timer_.begin();
    session_.step();
    auto const slow = timer_.end(session_.world());
    // In fast motion only every nth frame is heard, so that pitches stay as they are.
    auto const every = static_cast<std::uint64_t>(std::max(speed_.now(), 1.0));
    if (heard && session_.world().frame() % every == 0) {
        audio_.frame(session_.world(), view_.camera());
    }
    stepped_ = true;
    events_.afterStep();
    if (slow) {
        events_.slow(*slow);
    }
}

void RunControl::runOrStop() {
    if (building()) {
        begin(false);
    } else {
        stop();
    }
}

void RunControl::pauseOrGo() {
    if (running()) {
        session_.pause();
    } else if (paused()) {
        speed_.reset();
        session_.resume();
    }
}

void RunControl::step() {
    if (running()) {
        session_.pause();
    }
    speed_.reset();
    stepOnce();
}

void RunControl::begin(bool asBefore) {
    placing_.reset();
    speed_.reset();
    if (asBefore) {
        session_.startAgain();
    } else {
        session_.start();
    }
    audio_.enter(session_.world());
    events_.newWorld();
}

void RunControl::beginAgain(Playback done, std::uint64_t frame) {
    stop();
    begin(true);
    session_.play(std::move(done));
    target_ = frame;
    catchUp();
}

void RunControl::stop() {
    events_.stopping();
    target_.reset();
    audio_.leave();
    session_.stop();
    hand_.reset();
    speed_.reset();
    events_.stopped();
    events_.newWorld();
}

void RunControl::takeOver() {
    session_.takeOver();
}

void RunControl::watchAgain() {
    Playback done = session_.done();
    stop();
    begin(true);
    session_.play(std::move(done));
}

} // namespace trembler::ui
