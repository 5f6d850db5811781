#include "game/ui/play/whatif/what_if.hpp"

#include "game/ui/play/timeline/probe_panel.hpp"
#include "game/ui/play/whatif/what_if_lane.hpp"
#include "runtime/level/json/diagnostic.hpp"

#include <algorithm>

namespace trembler::ui {
namespace {

constexpr std::uint64_t otherFramesAtOnce = 60; // in one picture, of both runs

} // namespace

WhatIfView::WhatIfView(Registry const& registry, Session const& session, Timeline& timeline)
    : registry_(registry), session_(session), timeline_(timeline),
      stage_([&registry, &session] { return insight::buildAgain(registry, session); }) {}

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
    stage_.forget();
    staged_.reset();
    moving_ = false;
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
    try {
        next_ = std::make_unique<insight::OtherRun>(registry_, session_, whatIf_);
        moving_ = true;
    } catch (InputError const& error) {
        trouble_ = error.diagnostics().front().print();
        active_ = false;
        drop();
    }
}

void WhatIfView::pass() {
    if (!active_) {
        return;
    }
    if (!timeline_.open()) {
        end();
        return;
    }
    insight::OtherRun& computed = next_ ? *next_ : *shown_;
    try {
        moving_ = computed.advance(otherFramesAtOnce, timeline_.last());
    } catch (std::exception const& error) { // the changed world cannot go on
        trouble_ = error.what();
        active_ = false;
        drop();
        return;
    }
    if (next_ && next_->begun()) {
        shown_ = std::move(next_);
        stage_.forget();
        staged_.reset();
        timeline_.probes().forgetOther();
    }
    if (shown_) {
        moving_ = timeline_.probes().readOther(shown_->recording()) || moving_;
    }
}

World const* WhatIfView::world() {
    if (!active_ || !shown_ || timeline_.frame() < shown_->whatIf().frame ||
        timeline_.frame() > shown_->recording().last()) {
        return nullptr;
    }
    std::uint64_t const frame = shown_->recording().nearest(timeline_.frame());
    if (staged_ != frame) {
        try {
            stage_.show(shown_->recording(), frame);
            staged_ = frame;
        } catch (InputError const& error) {
            trouble_ = error.diagnostics().front().print();
            return nullptr;
        }
    }
    return &stage_.world();
}

std::vector<GoalStatus> const& WhatIfView::goals() const {
    static std::vector<GoalStatus> const none;
    return staged_ ? stage_.goals() : none;
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
