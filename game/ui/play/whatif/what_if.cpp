#include "game/ui/play/whatif/what_if.hpp"

#include "game/ui/play/timeline/probe_panel.hpp"
#include "game/ui/play/whatif/what_if_lane.hpp"
#include "runtime/level/json/diagnostic.hpp"

#include <algorithm>
#include <chrono>

namespace trembler::ui {
namespace {

constexpr double shareOfBuilding = 0.05; // of the progress that is shown

double secondsNow() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace

WhatIfView::WhatIfView(Registry const& registry, Session const& session, Timeline& timeline,
                       std::function<double()> clock)
    : registry_(registry), session_(session), timeline_(timeline), stage_(newStage()),
      clock_(clock ? std::move(clock) : secondsNow) {}

std::unique_ptr<insight::Stage> WhatIfView::newStage() const {
    return std::make_unique<insight::Stage>([this] { return insight::buildAgain(registry_, session_); });
}

bool WhatIfView::begin() {
    if (session_.altered()) {
        return false;
    }
    end();
    whatIf_ = {timeline_.frame(), {}};
    active_ = true;
    timeline_.setLane(whatIfLane);
    compute();
    return true;
}

void WhatIfView::end() {
    if (active_ && !whatIf_.changes.empty()) {
        std::erase(kept_, whatIf_);
        kept_.push_back(whatIf_);
        if (kept_.size() > mostKept) {
            kept_.erase(kept_.begin());
        }
    }
    active_ = false;
    drop();
}

void WhatIfView::again(std::size_t kept) {
    if (kept >= kept_.size() || session_.altered()) {
        return;
    }
    insight::WhatIf const wanted = kept_[kept];
    end();
    whatIf_ = wanted;
    active_ = true;
    timeline_.setLane(whatIfLane);
    toMoment();
    compute();
}

void WhatIfView::forget() {
    active_ = false;
    drop();
    kept_.clear();
}

void WhatIfView::drop() {
    shown_.reset();
    next_.reset();
    nextStage_.reset();
    stage_->forget();
    staged_.reset();
    moving_ = working_ = stopped_ = wanted_ = fresh_ = false;
    timeline_.setLane(0);
    timeline_.probes().forgetOther();
}

void WhatIfView::toMoment() {
    timeline_.seek(whatIf_.frame);
}

void WhatIfView::change(insight::Change change) {
    whatIf_.add(std::move(change));
    compute();
}

void WhatIfView::takeBack(std::size_t index) {
    if (index >= whatIf_.changes.size()) {
        return;
    }
    using Kind = insight::Change::Kind;
    if (whatIf_.changes[index].kind == Kind::input) {
        std::erase_if(whatIf_.changes,
                      [](insight::Change const& change) { return change.kind == Kind::input; });
    } else {
        whatIf_.changes.erase(whatIf_.changes.begin() + static_cast<std::ptrdiff_t>(index));
    }
    compute();
}

void WhatIfView::leaveOut(std::vector<std::size_t> const& inputs) {
    for (std::size_t const index : inputs) {
        whatIf_.add({.kind = insight::Change::Kind::input, .index = index});
    }
    compute();
}

void WhatIfView::compute() {
    next_.reset();
    nextStage_.reset();
    wanted_ = fresh_ = moving_ = working_ = true;
    stopped_ = false;
}

double WhatIfView::progress() const {
    insight::OtherRun const* const computed = next_ ? next_.get() : shown_.get();
    std::uint64_t const last = timeline_.last();
    if (computed == nullptr || wanted_ || last == 0) {
        return 0;
    }
    double const frames = std::min(static_cast<double>(computed->frame()) / static_cast<double>(last), 1.0);
    double const worlds = static_cast<double>(worldsBuilt()) / worldsToBuild;
    return shareOfBuilding * worlds + (1 - shareOfBuilding) * frames;
}

void WhatIfView::pass() {
    if (!active_) {
        return;
    }
    if (!timeline_.open()) {
        end();
        return;
    }
    if (std::exchange(fresh_, false)) {
        return; // the next change may come with the next picture, as while a number is dragged
    }
    try {
        computeOn();
    } catch (InputError const& error) { // the world cannot be built any more
        trouble_ = error.diagnostics().front().print();
        active_ = false;
        drop();
        return;
    } catch (std::exception const& error) { // the changed world cannot go on
        trouble_ = error.what();
        active_ = false;
        drop();
        return;
    }
    // At frame 0 it has begun with its last world, before the stage that shows it is built.
    if (next_ && worldsBuilt_ == worldsToBuild && next_->begun()) {
        shown_ = std::move(next_);
        stage_ = std::move(nextStage_);
        staged_.reset();
        timeline_.probes().forgetOther();
    }
    moving_ = working_ && !stopped_;
    if (shown_) {
        moving_ = timeline_.probes().readOther(shown_->recording()) || moving_;
    }
}

void WhatIfView::computeOn() {
    if (stopped_) {
        return;
    }
    pace_.begin();
    double now = clock_();
    auto const lap = [&] {
        double const before = std::exchange(now, clock_());
        return now - before;
    };
    if (buildOn()) {
        working_ = true;
        return;
    }
    insight::OtherRun* const computed = next_ ? next_.get() : shown_.get();
    if (computed == nullptr) {
        working_ = false;
        return;
    }
    working_ = true;
    for (std::uint64_t frames = pace_.next(); working_ && frames > 0; frames = pace_.next()) {
        std::uint64_t const before = computed->frame();
        working_ = computed->advance(frames, timeline_.last());
        pace_.took(computed->frame() - before, lap());
    }
}

bool WhatIfView::buildOn() {
    if (std::exchange(wanted_, false)) {
        next_ = std::make_unique<insight::OtherRun>(registry_, session_, whatIf_);
        nextStage_ = newStage();
        worldsBuilt_ = 0;
    }
    if (!next_ || worldsBuilt_ == worldsToBuild) {
        return false;
    }
    if (next_->built()) {
        nextStage_->prepare();
    } else {
        next_->build();
    }
    ++worldsBuilt_;
    return true;
}

World const* WhatIfView::world() {
    if (!active_ || !shown_ || timeline_.frame() < shown_->whatIf().frame ||
        timeline_.frame() > shown_->recording().last()) {
        return nullptr;
    }
    std::uint64_t const frame = shown_->recording().nearest(timeline_.frame());
    if (staged_ != frame) {
        try {
            stage_->show(shown_->recording(), frame);
            staged_ = frame;
        } catch (InputError const& error) {
            trouble_ = error.diagnostics().front().print();
            return nullptr;
        }
    }
    return &stage_->world();
}

std::vector<GoalStatus> const& WhatIfView::goals() const {
    static std::vector<GoalStatus> const none;
    return staged_ ? stage_->goals() : none;
}

std::vector<insight::SettableField> WhatIfView::fieldsOf(std::string const& object) {
    World const* const other = this->world();
    World const& world = other != nullptr ? *other : timeline_.world();
    std::vector<insight::SettableField> fields = insight::settableFields(world, world.store().find(object));
    for (insight::Change const& each : whatIf_.changes) {
        for (insight::SettableField& field : fields) {
            if (each.kind == insight::Change::Kind::field && each.object == object &&
                each.property == field.property->text.key && each.field == field.key) {
                field.now = each.amount;
            }
        }
    }
    return fields;
}

} // namespace trembler::ui
