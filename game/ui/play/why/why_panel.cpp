#include "game/ui/play/why/why_panel.hpp"

#include "game/ui/cards/level_text.hpp"
#include "game/ui/shared/words.hpp"

#include <algorithm>
#include <utility>

namespace trembler::ui {
namespace {

using insight::MarkKind;
using insight::StepKind;

/// The possible kinds of event at a mark.
std::vector<StepKind> kindsOf(MarkKind kind) {
    switch (kind) {
    case MarkKind::contact:
    case MarkKind::hit:
        return {StepKind::contact};
    case MarkKind::parted:
        return {StepKind::apart};
    case MarkKind::on:
        return {StepKind::on, StepKind::magnetOn};
    case MarkKind::off:
        return {StepKind::off, StepKind::magnetOff};
    case MarkKind::sound: // the impact, or the switching, that caused it
        return {StepKind::contact, StepKind::on, StepKind::other};
    case MarkKind::cut:
        return {StepKind::cut, StepKind::removed};
    case MarkKind::dips:
        return {StepKind::liquid};
    case MarkKind::magnetOn:
        return {StepKind::magnetOn};
    case MarkKind::magnetOff:
        return {StepKind::magnetOff};
    case MarkKind::leaves:
    case MarkKind::broken:
    case MarkKind::goal:
        break;
    }
    return {StepKind::other};
}

} // namespace

WhyPanel::WhyPanel(Registry const& registry, PartLibrary const& parts, std::shared_ptr<GameData const> data,
                   Session const& session, LevelText const& said)
    : session_(session), said_(said), inquiry_(registry, parts, std::move(data)) {}

bool WhyPanel::canAsk() const {
    if (session_.mode() != SessionMode::building) {
        return session_.world().frame() > 0;
    }
    return last_ ? !placedOtherwise() : !whyNot_.empty();
}

std::optional<RunAsked> WhyPanel::runNow() const {
    if (session_.mode() == SessionMode::building) {
        return last_;
    }
    if (session_.whyNotRecorded()) {
        return std::nullopt;
    }
    return RunAsked{session_.level(), session_.record(""), session_.world().frame()};
}

void WhyPanel::runEnds() {
    if (session_.mode() == SessionMode::building || session_.world().frame() == 0) {
        return;
    }
    last_ = runNow();
    whyNot_ = session_.whyNotRecorded().value_or("");
}

void WhyPanel::ask(insight::Question question, Subject subject) {
    if (!canAsk()) {
        return;
    }
    open_ = true;
    subject_ = std::move(subject);
    answer_.reset();
    nothing_ = false;
    fault_.clear();
    step_.reset();
    if (auto run = runNow()) {
        inquiry_.ask(std::move(*run), std::move(question));
        return;
    }
    inquiry_.forget();
    fault_ = session_.mode() == SessionMode::building ? whyNot_ : *session_.whyNotRecorded();
}

void WhyPanel::askGoal(std::string const& id) {
    insight::Question question;
    question.goal = id;
    ask(std::move(question), {.goal = id, .object = {}, .mark = {}});
}

void WhyPanel::askNextGoal() {
    std::vector<GoalStatus> const& all = session_.judge().status();
    if (all.empty()) {
        return;
    }
    auto const last = std::find_if(all.begin(), all.end(),
                                   [this](GoalStatus const& goal) { return goal.id == subject_.goal; });
    if (open_ && last != all.end()) {
        askGoal((last + 1 == all.end() ? all.begin() : last + 1)->id);
        return;
    }
    auto const missing =
        std::find_if(all.begin(), all.end(), [](GoalStatus const& goal) { return !goal.frame; });
    askGoal(missing != all.end() ? missing->id : all.back().id);
}

void WhyPanel::askObject(std::string const& name, std::uint64_t frame) {
    insight::Question question;
    question.object = name;
    question.at = static_cast<double>(frame) * frameDuration;
    ask(std::move(question), {.goal = {}, .object = name, .mark = {}});
}

void WhyPanel::askMark(insight::Mark const& mark) {
    if (mark.kind == MarkKind::goal) {
        askGoal(mark.goal);
        return;
    }
    insight::Question question;
    question.sighted = insight::SightedEvent{mark.frame, mark.objects, kindsOf(mark.kind)};
    ask(std::move(question), {.goal = {}, .object = {}, .mark = mark});
}

void WhyPanel::close() {
    inquiry_.forget();
    open_ = false;
    answer_.reset();
    step_.reset();
}

void WhyPanel::stopOrClose() {
    if (inquiry_.busy()) {
        inquiry_.stop();
    } else {
        close();
    }
}

bool WhyPanel::placedOtherwise() const {
    if (!last_) {
        return false;
    }
    Solution const now = session_.record("");
    Solution const& then = last_->solution;
    auto const samePlace = [](auto const& a, auto const& b) {
        return a.part == b.part && a.at == b.at && a.angle == b.angle && a.flipped == b.flipped;
    };
    auto const sameWire = [](auto const& a, auto const& b) { return a.a == b.a && a.b == b.b; };
    return !std::equal(now.placements.begin(), now.placements.end(), then.placements.begin(),
                       then.placements.end(), samePlace) ||
           !std::equal(now.wires.begin(), now.wires.end(), then.wires.begin(), then.wires.end(), sameWire);
}

void WhyPanel::pass() {
    if (open_ && session_.mode() == SessionMode::building && placedOtherwise()) {
        close(); // its places mean nothing any more
    }
    auto found = inquiry_.take();
    if (!found) {
        return;
    }
    nothing_ = found->nothing;
    fault_ = std::move(found->fault);
    answer_ = std::move(found->answer);
    if (answer_ && !answer_->complete && !answer_->happened) {
        close(); // it was stopped before it had any result
    }
}

std::string WhyPanel::goalText(std::string const& id) const {
    std::vector<GoalStatus> const& all = session_.judge().status();
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].id == id) {
            return i < said_.goals().size() ? said_.goals()[i] : all[i].text;
        }
    }
    return id;
}

std::string WhyPanel::subjectText() const {
    if (!subject_.goal.empty()) {
        return words::capital(goalText(subject_.goal));
    }
    if (!subject_.object.empty()) {
        return words::capital(answerLanguageInUse().the(subject_.object));
    }
    return "";
}

std::size_t WhyPanel::steps() const {
    if (!answer_) {
        return 0;
    }
    return answer_->happened ? answer_->chain.size() : answer_->nearest ? 1 : 0;
}

std::uint64_t WhyPanel::frameOf(std::size_t step) const {
    return answer_->happened ? answer_->chain[step].step.frame : answer_->nearest->nearest.frame;
}

std::vector<std::string> WhyPanel::lines() const {
    std::vector<std::string> all;
    if (!answer_) {
        return all;
    }
    insight::AnswerLanguage const language = answerLanguageInUse();
    if (!answer_->happened) {
        return sentencesOf(*answer_, goalText(answer_->goal), language);
    }
    for (insight::ChainStep const& one : answer_->chain) {
        all.push_back(
            words::capital(clausesOf(one.step, answer_->facts, goalText(answer_->goal), language).main) +
            ".");
    }
    return all;
}

std::optional<std::uint64_t> WhyPanel::goToStep(bool next) {
    std::size_t const count = steps();
    if (count == 0) {
        return std::nullopt;
    }
    if (!step_) {
        step_ = next ? 0 : count - 1;
    } else {
        step_ = (*step_ + (next ? 1 : count - 1)) % count;
    }
    toStep_ = true;
    return frameOf(*step_);
}

} // namespace trembler::ui
