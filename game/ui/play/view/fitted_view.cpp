#include "game/ui/play/view/fitted_view.hpp"

#include "game/ui/cards/play_cards.hpp"
#include "game/ui/play/play_parts.hpp"
#include "game/ui/shared/card_sizes.hpp"
#include "game/ui/tools/free_fit.hpp"

#include <algorithm>
#include <utility>

namespace trembler::ui {
namespace {

constexpr std::array standingCards{"goal", "toolbox", "transport", "tools", "corner"};
constexpr std::size_t goalIndex = 0;
constexpr std::size_t toolboxIndex = 1;
/// Cards of one entry take each other's place.
constexpr std::array<std::array<char const*, 2>, 3> openedCards{
    {{"components", "mods"}, {"inspector", "why"}, {"legend", "legend"}}};
/// Those with which the player works on the past, at the left above the timeline.
constexpr std::array cardsOfPast{"what if", "probe choice"};

constexpr double cardClearance = 6; // pixels at UI scale 1, around a card
/// A level that would be smaller than this, as a share of its size without the card, is shown as without it,
/// and the card covers it: it could hardly be recognised beside the card.
constexpr double worthwhile = 0.33;

bool sameCard(std::optional<Rect> const& a, std::optional<Rect> const& b) {
    return a.has_value() == b.has_value() && (!a || (a->low == b->low && a->high == b->high));
}

} // namespace

void FittedView::follow(PlayParts& parts, bool cards) {
    lookAtWindow(parts);
    bool const building = parts.run.building();
    // In a run the level counts as it was at its start: something may have rolled far away since.
    if (std::exchange(wasBuilding_, building) != building || extents_.seen.empty()) {
        extents_ = levelExtents(parts.session, parts.goals, parts.catalog());
    }
    bool const settles = pictures_ >= 0;
    // The first picture's cards are still those of the other window, or none.
    bool const known = settles && cards && pictures_++ > 0 && !lookAtStanding(parts) && pictures_ > 2;
    if (settles) {
        setStage(parts);
    }
    bool const settled = known || pictures_ > settling;
    bool const wanted = std::exchange(parts.fitWanted, false);
    if (!settled && !wanted) {
        return;
    }
    if (building) {
        extents_ = levelExtents(parts.session, parts.goals, parts.catalog());
    }
    if (wanted && !settles && building && cards) {
        standing_ = {}; // as they are now
        lookAtStanding(parts);
        setStage(parts);
    }
    timeline_ = parts.timeline.shown() ? parts.timeline.height() : 0;
    opened_ = {};
    ofPast_.reset();
    if (cards) {
        lookAtPast(parts);
    }
    if (wanted && cards) {
        lookAtOpened(parts);
    }
    fit(parts);
    if (wanted) {
        parts.view.fit();
    }
    if (settled) {
        pictures_ = -1;
    }
    parts.view.hold();
}

void FittedView::lookAtWindow(PlayParts& parts) {
    render::Size const window = parts.context.window.size();
    auto const scale = static_cast<double>(parts.context.window.uiScale());
    if (window == window_ && scale == scale_) {
        return;
    }
    window_ = window;
    scale_ = scale;
    standing_ = {};
    pictures_ = 0;
    parts.view.release();
}

bool FittedView::lookAtStanding(PlayParts const& parts) {
    bool changed = false;
    for (std::size_t i = 0; i < standingCards.size(); ++i) {
        if (auto const card = parts.context.layout.card(standingCards[i])) {
            auto const before = std::exchange(standing_[i], card);
            changed = changed || !sameCard(before, standing_[i]);
        }
    }
    if (auto& goal = standing_[goalIndex]; goal && parts.run.building()) {
        goalHeight_ = (goal->high.y - goal->low.y) / scale_;
    } else if (goal) { // it is smaller in a run
        goal->high.y = std::max(goal->high.y, goal->low.y + scale_ * goalHeight_);
    }
    return changed;
}

std::optional<Rect> FittedView::columnOf(PlayParts const& parts, char const* name) const {
    double const bottom = window_.height - scale_ * static_cast<double>(bottomRow);
    auto card = parts.context.layout.card(name);
    if (card) {
        card->high.y = std::max(card->high.y, bottom);
    }
    return card;
}

void FittedView::lookAtPast(PlayParts const& parts) {
    for (char const* const name : cardsOfPast) {
        if (auto const card = parts.timeline.shown() ? columnOf(parts, name) : std::nullopt) {
            ofPast_ = card;
        }
    }
}

void FittedView::lookAtOpened(PlayParts const& parts) {
    for (std::size_t i = 0; i < openedCards.size(); ++i) {
        for (char const* const name : openedCards[i]) {
            if (auto const card = columnOf(parts, name)) {
                opened_[i] = card;
            }
        }
    }
}

void FittedView::setStage(PlayParts& parts) {
    auto const& goal = standing_[goalIndex];
    auto const toolbox = toolboxPlace(parts);
    double const gap = scale_ * static_cast<double>(cardGap);
    double const clear = scale_ * cardClearance;
    double const above = goal ? goal->high.y : gap + scale_ * goalHeight_;
    stage_.low = {0, std::max(above + clear, scale_ * static_cast<double>(cornerRow))};
    stage_.high = {toolbox ? toolbox->low.x - clear : window_.width,
                   window_.height - scale_ * (static_cast<double>(bottomRow) + cardClearance)};
    double const right = window_.width - stage_.high.x + (toolbox ? gap - clear : gap);
    parts.view.setView(window_, {gap, stage_.low.y, right, window_.height - stage_.high.y});
}

/// Where it is, or, as long as that is not known, the column in which it will be.
std::optional<Rect> FittedView::toolboxPlace(PlayParts const& parts) const {
    LevelFile const& level = parts.session.level();
    if (standing_[toolboxIndex] || (level.toolbox.empty() && level.wires == 0)) {
        return standing_[toolboxIndex];
    }
    double const gap = scale_ * static_cast<double>(cardGap);
    auto const width = static_cast<float>(window_.width / scale_);
    double const right = window_.width - gap;
    return Rect{{right - scale_ * static_cast<double>(toolboxWidth(width, hasLargeToolbox(parts.session))),
                 scale_ * static_cast<double>(cornerRow)},
                {right, window_.height - scale_ * static_cast<double>(bottomRow)}};
}

/// Beside a card of the past as it is now: the goals may have made way for it, and the buttons of a run be
/// more.
std::optional<Rect> FittedView::standing(PlayParts const& parts, std::size_t i, bool withOpened) const {
    if (!withOpened || !ofPast_ || i == toolboxIndex) {
        return standing_[i];
    }
    auto const now = parts.context.layout.card(standingCards[i]);
    return now && i == goalIndex ? standing_[i] : now; // the goals are higher while the player builds
}

FittedView::Cards FittedView::obstacles(PlayParts const& parts, bool withOpened) const {
    Cards all;
    render::Point const clear{cardClearance * scale_, cardClearance * scale_};
    auto const add = [&](std::optional<Rect> const& card) {
        if (card) {
            all.push_back({card->low - clear, card->high + clear});
        }
    };
    for (std::size_t i = 0; i < standing_.size(); ++i) {
        add(standing(parts, i, withOpened));
    }
    add(toolboxPlace(parts));
    if (withOpened) {
        std::for_each(opened_.begin(), opened_.end(), add);
        add(ofPast_);
        if (timeline_ > 0) {
            double const top = window_.height - scale_ * (static_cast<double>(bottomRow + timeline_) + 6);
            all.push_back(
                {{0, top}, {static_cast<double>(window_.width), static_cast<double>(window_.height)}});
        }
    }
    return all;
}

void FittedView::fit(PlayParts& parts) const {
    auto const fitted = [&](bool withOpened, double least) {
        Cards const cards = obstacles(parts, withOpened);
        Cards goal;
        if (auto const card = standing(parts, goalIndex, withOpened)) {
            goal.push_back(*card);
        }
        bool const past = withOpened && timeline_ > 0; // then no part is held
        std::array const groups{FitGroup{extents_.seen, cards}, FitGroup{extents_.around, goal},
                                FitGroup{extents_.places, past ? goal : cards}};
        return freeFit(window_, groups, scale_ * static_cast<double>(cardGap), least,
                       render::Camera::largestScale);
    };
    double const least = parts.view.scaleBetweenMargins();
    auto const covered = fitted(false, least);
    double const whole = covered ? covered->pixelsPerMetre : least;
    auto const beside = fitted(true, worthwhile * whole);
    parts.view.setPreferred(beside ? beside : covered);
}

} // namespace trembler::ui
