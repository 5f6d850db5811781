#include "game/ui/play/timeline/timeline.hpp"

#include "game/ui/play/timeline/probe_panel.hpp"
#include "game/ui/play/timeline/timeline_bar.hpp"
#include "render/scene/facts/shape_geometry.hpp"
#include "runtime/level/json/diagnostic.hpp"

#include <algorithm>
#include <utility>

namespace trembler::ui {
namespace {

constexpr std::uint64_t ringsLast = 60; // frames that a ring of sound is seen

} // namespace

Timeline::Timeline(Registry const& registry, Session const& session)
    : session_(session), stage_([&registry, &session] { return insight::buildAgain(registry, session); }),
      probes_(std::make_shared<ProbePanel>(registry, session)) {}

float Timeline::height() const {
    return open_ ? timelineRow + lane_ + probes_->height() : 0;
}

void Timeline::beforeStep() {
    if (session_.world().frame() == 0 && !target_) {
        stopped();
        recording_.begin(session_.world(), session_.judge());
    }
}

void Timeline::afterStep() {
    recording_.add(session_.world(), session_.judge());
    marks_.look(session_.world(), session_.judge());
    if (target_) {
        if (session_.world().frame() < *target_) {
            return;
        }
        target_.reset();
    }
    at_.reset();
    playing_ = false;
}

void Timeline::stopped() {
    if (std::exchange(spared_, false)) {
        return;
    }
    recording_.clear();
    probes_->forget();
    marks_.clear();
    stage_.forget();
    at_.reset();
    target_.reset();
    loop_.reset();
    heard_.reset();
    playing_ = false;
}

void Timeline::beginAgain() {
    target_ = frame();
    spared_ = true;
    playing_ = false;
    loop_.reset();
    recording_.forgetAfter(*target_);
    marks_.forgetAfter(*target_);
    probes_->forgetAfter(*target_);
    if (*target_ == 0) { // nothing is to be computed
        target_.reset();
        at_.reset();
    }
}

void Timeline::setOpen(bool open) {
    open_ = open;
    if (!open && !target_) {
        at_.reset();
        playing_ = false;
    }
}

void Timeline::seek(std::uint64_t frame) {
    if (!recording_.begun() || target_) {
        return;
    }
    if (frame >= recording_.last()) {
        at_.reset();
    } else {
        show(recording_.nearest(frame));
    }
}

void Timeline::show(std::uint64_t frame) {
    try {
        hear(frame);
        stage_.show(recording_, frame);
        at_ = frame;
    } catch (InputError const& error) {
        trouble_ = error.diagnostics().front().print();
        at_.reset();
        playing_ = false;
    }
}

void Timeline::hear(std::uint64_t frame) {
    bool const goesOn = heard_ && *heard_ <= frame && frame - *heard_ <= ringsLast;
    std::uint64_t next = goesOn ? *heard_ + 1 : frame - std::min(frame, ringsLast);
    if (!goesOn) {
        rings_.clear();
    }
    for (std::uint64_t before = next - std::min<std::uint64_t>(next, 1); next <= frame; ++next) {
        std::uint64_t const recorded = recording_.nearest(next);
        if (recorded == before) {
            continue;
        }
        stage_.show(recording_, recorded);
        rings_.advance(frameDuration * static_cast<double>(recorded - std::min(before, recorded)));
        if (auto const* const sounds = stage_.world().find<Sounds>()) {
            rings_.hear(*sounds);
        }
        before = recorded;
    }
    heard_ = frame;
}

std::vector<render::Ripple> Timeline::ripples() const {
    std::vector<render::Ripple> ripples;
    for (SoundRing const& ring : rings_.rings()) {
        ripples.push_back({render::toPoint(ring.at), ring.radius, ring.strength});
    }
    return ripples;
}

void Timeline::stepBy(int frames) {
    std::uint64_t to = frame();
    for (; frames < 0; ++frames) {
        to = recording_.before(to).value_or(to);
    }
    for (; frames > 0; --frames) {
        to = recording_.after(to).value_or(to);
    }
    seek(to);
}

bool Timeline::seekMark(bool forwards) {
    insight::Mark const* const mark = forwards ? marks_.after(frame()) : marks_.before(frame());
    if (mark != nullptr) {
        seek(mark->frame);
    }
    return mark != nullptr;
}

void Timeline::playOrPause() {
    playing_ = !playing_ && recording_.begun() && recording_.last() > 0;
    due_ = 0;
    if (playing_ && !at_) {
        seek(loop_ ? loop_->first : 0);
    }
}

void Timeline::markLoop() {
    std::uint64_t const here = frame();
    if (!loop_) {
        loop_ = {here, recording_.last()};
        loopEnds_ = false;
    } else if (!loopEnds_ && here != loop_->first) {
        loop_ = std::minmax(loop_->first, here);
        loopEnds_ = true;
    } else {
        loop_.reset();
    }
}

void Timeline::pass(double seconds, double speed) {
    reading_ = open_ && probes_->read(recording_);
    if (!playing_ || !at_) {
        playing_ = false;
        return;
    }
    due_ += std::clamp(seconds, 0.0, 0.25) * speed / frameDuration;
    auto const whole = static_cast<std::uint64_t>(due_);
    if (whole == 0) {
        return;
    }
    due_ -= static_cast<double>(whole);
    std::uint64_t to = *at_ + whole;
    if (loop_ && to > loop_->second) {
        to = loop_->first;
    }
    // Where the recording is thin, its next frame is waited for.
    std::uint64_t const next = recording_.after(*at_).value_or(recording_.last());
    if (to < next && !loop_) {
        due_ += static_cast<double>(whole);
        return;
    }
    seek(to);
    playing_ = at_.has_value();
}

} // namespace trembler::ui
