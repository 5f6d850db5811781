#include "insight/whatif/other_run.hpp"

#include "insight/timeline/again.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trembler::insight {
namespace {

constexpr double leastApart = 2e-3;  // m
constexpr double leastTurned = 0.01; // rad

} // namespace

bool isElsewhere(Store const& real, Store const& other, ObjectId object) {
    auto const* const placesA = real.findColumn<Position>();
    auto const* const placesB = other.findColumn<Position>();
    Position const* const a = placesA == nullptr ? nullptr : placesA->find(object);
    Position const* const b = placesB == nullptr ? nullptr : placesB->find(object);
    if (a == nullptr || b == nullptr) {
        return a != b;
    }
    auto const* const turnsA = real.findColumn<Rotation>();
    auto const* const turnsB = other.findColumn<Rotation>();
    Rotation const* const angleA = turnsA == nullptr ? nullptr : turnsA->find(object);
    Rotation const* const angleB = turnsB == nullptr ? nullptr : turnsB->find(object);
    double const turn = (angleA == nullptr ? 0 : angleA->angle) - (angleB == nullptr ? 0 : angleB->angle);
    return length(a->value - b->value) > leastApart || std::abs(turn) > leastTurned;
}

OtherRun::OtherRun(Registry const& registry, Session const& session, WhatIf whatIf)
    : registry_(registry), session_(session), whatIf_(std::move(whatIf)) {
    objectsOnly_ = std::any_of(whatIf_.changes.begin(), whatIf_.changes.end(),
                               [](Change const& each) { return each.kind == Change::Kind::interaction; });
}

bool OtherRun::build() {
    if (real_ == nullptr) {
        real_ = buildAgain(registry_, session_);
        real_->begin();
        return true;
    }
    if (other_ == nullptr) {
        other_ = buildAgain(registry_, session_);
        other_->begin();
        if (whatIf_.frame == 0) {
            change();
        }
    }
    return false;
}

bool OtherRun::advance(std::uint64_t most, std::uint64_t last) {
    while (!built()) {
        build();
    }
    for (; most > 0 && frame() < last; --most) {
        step();
        if (frame() == whatIf_.frame) {
            change();
        }
    }
    return frame() < last;
}

void OtherRun::step() {
    // The session's run may have gone on since.
    if (session_.inputs().size() != inputsKnown_ || session_.changes().size() != changesKnown_) {
        inputsKnown_ = session_.inputs().size();
        changesKnown_ = session_.changes().size();
        std::vector<RecordedChange> const changes(session_.changes().begin(), session_.changes().end());
        realInputs_ = Playback({session_.inputs().begin(), session_.inputs().end()}, changes);
        std::vector<RecordedInput> inputs = inputsLeft(session_.inputs(), whatIf_, hand_);
        std::vector<RecordedInput> const own = inputsOfGrabs(whatIf_, hand_);
        inputs.insert(inputs.end(), own.begin(), own.end());
        std::vector<RecordedChange> others = changes; // a period would apply again what is left out
        std::erase_if(others, [this](RecordedChange const& change) {
            return change.kind == RecordedChange::Kind::period &&
                   std::any_of(whatIf_.changes.begin(), whatIf_.changes.end(), [&](Change const& each) {
                       return each.kind == Change::Kind::interaction && each.object == change.subject;
                   });
        });
        otherInputs_ = Playback(std::move(inputs), std::move(others));
    } else if (inputsKnown_ == 0 && changesKnown_ == 0 && frame() == whatIf_.frame) {
        otherInputs_ = Playback(inputsOfGrabs(whatIf_, hand_), {});
    }
    realInputs_.feed(*real_);
    otherInputs_.feed(*other_);
    real_->step();
    other_->step();
    if (frame() <= whatIf_.frame) {
        return;
    }
    recording_.add(other_->world(), other_->judge());
    if (!differs_ && hashOf(real_->world()) != hashOf(other_->world())) {
        differs_ = frame();
    }
    if (differs_) {
        notePaths();
    }
}

void OtherRun::change() {
    hand_ = handOfGrab(session_.inputs(), whatIf_);
    inputsKnown_ = 0; // those of the other run depend on it
    changesKnown_ = 0;
    apply(registry_, *other_, whatIf_, hand_);
    recording_.begin(other_->world(), other_->judge());
    notePaths();
}

std::uint64_t OtherRun::hashOf(World const& world) const {
    return objectsOnly_ ? world.store().hash() : world.stateHash();
}

void OtherRun::notePaths() {
    Store const& store = other_->world().store();
    auto const* const speeds = store.findColumn<Velocity>();
    auto const* const places = store.findColumn<Position>();
    if (places == nullptr) {
        return;
    }
    for (std::size_t row = 0; row < places->size(); ++row) {
        ObjectId const object = places->owners()[row];
        bool const moves = speeds != nullptr && speeds->has(object);
        if (!moves || !isElsewhere(real_->world().store(), store, object)) {
            continue;
        }
        std::vector<OtherPath::At>& points = paths_[object].points;
        Vec2 const at = places->values()[row].value;
        if (points.empty() || (points.size() < mostPoints && length(at - points.back().at) >= pathStep)) {
            points.push_back({frame(), at});
        }
    }
}

} // namespace trembler::insight
