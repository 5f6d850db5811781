#include "game/ui/play/view/fitted_view.hpp"

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

constexpr double cardClearance = 6; // pixels at UI scale 1, around a card
constexpr double enoughRoom = 200;  // pixels at UI scale 1, between the cards at the left and the right
/// A level that would be smaller than this, as a share of its size without the card, stays where it is and
/// the card covers it: it could hardly be recognised beside the card.
constexpr double worthwhile = 0.5;
/// A card has no size in its first pictures; as long the one whose place it takes counts.
constexpr int picturesWithoutSize = 6;

Rect around(Rect const& a, Rect const& b) {
    return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
            {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

bool same(std::optional<Rect> const& a, std::optional<Rect> const& b) {
    return a.has_value() == b.has_value() && (!a || (a->low == b->low && a->high == b->high));
}

bool samePlace(PlacedPart const& a, PlacedPart const& b) {
    return a.number == b.number && a.placement.at == b.placement.at &&
           a.placement.angle == b.placement.angle && a.placement.flipped == b.placement.flipped;
}

/// The player holds something that would move with the view.
bool holdsSomething(PlayParts const& parts) {
    return parts.placing.carried() || parts.group.dragging() || parts.hand.busy() || parts.secondHand.busy();
}

} // namespace

void FittedView::follow(PlayParts& parts, bool cards) {
    bool changed = lookAtWindow(parts);
    bool const timeline = std::exchange(timeline_, parts.timeline.height()) != parts.timeline.height();
    bool const holds = holdsSomething(parts);
    if (cards && !holds) {
        changed = lookAtOpened(parts) || changed;
    }
    if (timeline || (parts.run.building() && !holds)) {
        changed = lookAtStanding(parts) || timeline || changed;
    }
    if (parts.run.building() && !holds) {
        changed = lookAtPlaced(parts) || changed;
    }
    // In a run the level counts as it was at its start: something may have rolled far away since.
    bool const building = parts.run.building();
    bool const turned = std::exchange(wasBuilding_, building) != building;
    if (extents_.seen.empty() || (changed && building) || turned) {
        extents_ = levelExtents(parts.session, parts.goals, parts.catalog());
    }
    changed = changed || (turned && building && !toolbox_);
    if (changed) { // and not where a run begins, so that this does not move the view
        toolbox_ = building || (!opened_[0] && !opened_[1]);
    }
    bool const room = setMargins(parts);
    if (changed) {
        fit(parts, room);
    }
}

bool FittedView::lookAtWindow(PlayParts const& parts) {
    render::Size const window = parts.context.window.size();
    auto const scale = static_cast<double>(parts.context.window.uiScale());
    if (window == window_ && scale == scale_) {
        return false;
    }
    window_ = window;
    scale_ = scale;
    standing_ = {};
    opened_ = {};
    return false; // without cards there is nothing to fit between
}

bool FittedView::lookAtStanding(PlayParts const& parts) {
    bool changed = false;
    for (std::size_t i = 0; i < standingCards.size(); ++i) {
        if (auto const card = parts.context.layout.card(standingCards[i])) {
            // A card that changes its size from picture to picture must not move the view each time.
            auto const before = std::exchange(standing_[i], around(*card, standing_[i].value_or(*card)));
            changed = changed || !same(before, standing_[i]);
        }
    }
    return changed;
}

bool FittedView::lookAtOpened(PlayParts const& parts) {
    bool changed = false;
    double const bottom = window_.height - scale_ * static_cast<double>(bottomRow);
    for (std::size_t i = 0; i < openedCards.size(); ++i) {
        std::optional<Rect> now;
        for (char const* const name : openedCards[i]) {
            if (auto const card = parts.context.layout.card(name)) {
                now = Rect{card->low, {card->high.x, std::max(card->high.y, bottom)}};
            }
        }
        missing_[i] = now ? 0 : missing_[i] + 1;
        if (now) {
            now = around(*now, opened_[i].value_or(*now));
        } else if (missing_[i] <= picturesWithoutSize) {
            now = opened_[i];
        }
        auto const before = std::exchange(opened_[i], now);
        changed = changed || !same(before, now);
    }
    return changed;
}

bool FittedView::setMargins(PlayParts& parts) const {
    auto const gap = static_cast<double>(cardGap);
    LevelFile const& level = parts.session.level();
    bool const boxed = toolbox_ && (!level.toolbox.empty() || level.wires > 0);
    double const width = window_.width / scale_;
    double left = static_cast<double>(goalCardWidth) + 2 * gap;
    double right = boxed ? static_cast<double>(toolboxWidth) + 2 * gap : gap;
    double const besideLeft = opened_[0] ? opened_[0]->high.x / scale_ + gap : left;
    double const besideRight = opened_[1] ? std::max(width - opened_[1]->low.x / scale_ + gap, right) : right;
    bool const room = width - besideLeft - besideRight >= enoughRoom;
    if (room) {
        left = besideLeft;
        right = besideRight;
    }
    double const below = static_cast<double>(bottomRow + timeline_) + 6;
    parts.view.setView(window_, {scale_ * left, scale_ * gap, scale_ * right, scale_ * below});
    return room;
}

bool FittedView::lookAtPlaced(PlayParts& parts) {
    std::vector<PlacedPart> const& placed = parts.session.placed();
    if (std::equal(placed.begin(), placed.end(), placed_.begin(), placed_.end(), samePlace)) {
        return false;
    }
    placed_ = placed;
    LevelExtents const now = levelExtents(parts.session, parts.goals, parts.catalog());
    auto const anyUnder = [&](std::vector<render::Extent> const& extents, Cards const& cards) {
        return std::any_of(extents.begin(), extents.end(), [&](render::Extent const& extent) {
            Rect const shown = onScreen(parts.camera(), extent);
            return std::any_of(cards.begin(), cards.end(),
                               [&](Rect const& card) { return card.overlaps(shown); });
        });
    };
    return anyUnder(now.seen, obstacles(false)) || anyUnder(now.around, onlyGoal());
}

FittedView::Cards FittedView::onlyGoal() const {
    auto const& goal = standing_[goalIndex];
    return goal ? Cards{*goal} : Cards{};
}

FittedView::Cards FittedView::obstacles(bool withOpened, bool withGoal) const {
    Cards all;
    render::Point const clear{cardClearance * scale_, cardClearance * scale_};
    auto const add = [&](std::optional<Rect> const& card) {
        if (card) {
            all.push_back({card->low - clear, card->high + clear});
        }
    };
    for (std::size_t i = 0; i < standing_.size(); ++i) {
        bool const counts = i == goalIndex ? withGoal : i != toolboxIndex || toolbox_;
        add(counts ? standing_[i] : std::nullopt);
    }
    if (withOpened) {
        std::for_each(opened_.begin(), opened_.end(), add);
    }
    if (timeline_ > 0) { // also while it is not drawn yet, so that nothing moves when a run begins
        double const top = window_.height - scale_ * (static_cast<double>(bottomRow + timeline_) + 6);
        all.push_back({{0, top}, {static_cast<double>(window_.width), static_cast<double>(window_.height)}});
    }
    return all;
}

void FittedView::fit(PlayParts& parts, bool room) const {
    auto const fitted = [&](bool withOpened, double least) {
        Cards const cards = obstacles(withOpened);
        Cards const whileHeld = obstacles(withOpened, false);
        Cards const goal = onlyGoal();
        std::array const groups{FitGroup{extents_.seen, cards}, FitGroup{extents_.around, goal},
                                FitGroup{extents_.places, whileHeld}};
        return freeFit(window_, groups, scale_ * static_cast<double>(cardGap), least,
                       render::Camera::largestScale);
    };
    double const least = parts.view.scaleBetweenMargins();
    if (room) {
        parts.view.setPreferred(fitted(true, least));
        return;
    }
    auto const covered = fitted(false, least);
    double const whole = covered ? covered->pixelsPerMetre : least;
    auto const beside = fitted(true, worthwhile * whole);
    parts.view.setPreferred(beside ? beside : covered);
}

} // namespace trembler::ui
