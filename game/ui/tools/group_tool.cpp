#include "game/ui/tools/group_tool.hpp"

#include "game/ui/shared/words.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::ui {
namespace {

constexpr double groupReasonTime = 2.5; // that a reason is shown

Vec2 centreOf(std::span<PlacedPart const> parts) {
    Vec2 sum;
    for (PlacedPart const& part : parts) {
        sum += part.placement.at;
    }
    return sum * (1 / static_cast<double>(parts.size()));
}

std::vector<PlacedPart> shifted(std::vector<PlacedPart> parts, Vec2 by) {
    for (PlacedPart& part : parts) {
        part.placement.at += by;
    }
    return parts;
}

} // namespace

bool GroupTool::isChosen(int number) const {
    return std::binary_search(chosen_.begin(), chosen_.end(), number);
}

std::vector<PlacedPart> GroupTool::parts() const {
    std::vector<PlacedPart> all;
    for (PlacedPart const& part : session_.placed()) {
        if (isChosen(part.number)) {
            all.push_back(part);
        }
    }
    return all;
}

void GroupTool::choose(std::vector<int> numbers) {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    bool const one = numbers.size() == 1;
    placing_.select(one ? std::optional(numbers.front()) : std::nullopt);
    chosen_ = one ? std::vector<int>{} : std::move(numbers);
}

void GroupTool::chooseAll() {
    std::vector<int> all;
    for (PlacedPart const& part : session_.placed()) {
        all.push_back(part.number);
    }
    placing_.cancel();
    choose(std::move(all));
}

void GroupTool::toggle(int number, std::optional<int> before) {
    std::vector<int> next = chosen_;
    if (next.empty() && before) {
        next.push_back(*before);
    }
    if (std::erase(next, number) == 0) {
        next.push_back(number);
    }
    choose(std::move(next));
}

void GroupTool::reset() {
    chosen_.clear();
    landings_.clear();
    press_.reset();
    box_.reset();
}

bool GroupTool::cancel() {
    press_.reset();
    if (dragging() || box_) {
        landings_.clear();
        box_.reset();
        return true;
    }
    bool const had = any();
    chosen_.clear();
    return had;
}

void GroupTool::forgetLost() {
    auto const lost = [&](int number) { return placing_.placementOf(number) == nullptr; };
    if (std::any_of(chosen_.begin(), chosen_.end(), lost)) { // by undo, for example
        landings_.clear();
        std::vector<int> left = chosen_;
        std::erase_if(left, lost);
        choose(std::move(left));
    }
}

bool GroupTool::updateBox(Pointer const& pointer) {
    box_->second = pointer.world;
    if (pointer.held) {
        return true;
    }
    auto const [a, b] = *box_;
    box_.reset();
    std::vector<int> inside = chosen_;
    if (inside.empty() && placing_.selected()) {
        inside.push_back(*placing_.selected());
    }
    for (PlacedPart const& part : session_.placed()) {
        Vec2 const at = part.placement.at;
        if (at.x >= std::min(a.x, b.x) && at.x <= std::max(a.x, b.x) && at.y >= std::min(a.y, b.y) &&
            at.y <= std::max(a.y, b.y)) {
            inside.push_back(part.number);
        }
    }
    choose(std::move(inside));
    return true;
}

void GroupTool::settle(std::vector<PlacedPart> wanted) {
    landings_ = std::move(wanted);
    verdict_ = session_.checkAll(landings_);
}

void GroupTool::startDrag() {
    landings_ = parts();
    grip_ = landings_.front().placement.at - press_->at;
    verdict_ = {};
}

void GroupTool::follow(Pointer const& pointer) {
    Vec2 to = pointer.world + grip_;
    std::vector<PlacedPart> const now = parts();
    Vec2 by = to - now.front().placement.at;
    if (!pointer.free) {
        double const step = pointer.fine ? gridStep / 5 : gridStep;
        by = {std::round(by.x / step) * step, std::round(by.y / step) * step};
    }
    // The parts may have been turned since they were taken.
    settle(shifted(landings_, now.front().placement.at + by - landings_.front().placement.at));
}

void GroupTool::drop(Pointer const& pointer) {
    press_.reset();
    if (pointer.overToolbox) {
        putBack();
    } else if (pointer.overCard) {
        return; // they stay in the hand, and follow the mouse until the next click
    } else if (verdict_.ok) {
        session_.moveAll(landings_);
        landings_.clear();
    } else { // they stay there, too, and the reason is shown beside them
        toasts_.countTrouble();
    }
}

void GroupTool::place(std::vector<PlacedPart> const& wanted) {
    Verdict const verdict = session_.checkAll(wanted);
    if (!verdict.ok) {
        toasts_.add(words::capital(translated(verdict.why)), render::ToastKind::Trouble, groupReasonTime);
    } else {
        session_.moveAll(wanted);
    }
}

/// The parts are in the hand without a button held, as they could not be left where it was released.
bool GroupTool::updateDragged(Pointer const& pointer) {
    if (pointer.rightClicked) {
        landings_.clear();
        return true;
    }
    follow(pointer);
    if (pointer.pressed) {
        drop(pointer);
    }
    return true;
}

bool GroupTool::updatePress(Pointer const& pointer) {
    bool const strayed = pointer.strayed(press_->screen) > dragThreshold;
    if (pointer.held) {
        if (strayed && press_->member && !dragging()) {
            startDrag();
        } else if (strayed && !press_->member) {
            press_.reset(); // the placing tool drags this one
            return false;
        }
        if (dragging()) {
            follow(pointer);
        }
        return press_->member;
    }
    Press const press = *press_;
    if (dragging()) {
        drop(pointer);
    } else if (press.toggles) {
        toggle(press.number, press.before);
    } else {
        choose({press.number});
    }
    press_.reset();
    return true;
}

bool GroupTool::update(Pointer const& pointer, std::optional<int> hovered) {
    forgetLost();
    if (box_) {
        return updateBox(pointer);
    }
    if (dragging() && pointer.wheel != 0 && !pointer.overCard) {
        turn(pointer.wheel > 0 ? 1 : -1, pointer.fine);
    }
    if (press_) {
        return updatePress(pointer);
    }
    if (dragging()) {
        return updateDragged(pointer);
    }
    if (placing_.carried() || pointer.overCard) {
        return false;
    }
    if (pointer.rightClicked && hovered && isChosen(*hovered)) {
        putBack();
        return true;
    }
    if (!pointer.pressed) {
        return false;
    }
    if (!hovered) {
        if (pointer.fine) {
            box_ = {pointer.world, pointer.world};
            return true;
        }
        chosen_.clear();
        return false;
    }
    bool const member = isChosen(*hovered);
    if (member || pointer.fine) {
        press_ = Press{*hovered, pointer.world, pointer.screen, member, pointer.fine, placing_.selected()};
    } else {
        chosen_.clear();
    }
    return member;
}

std::vector<PlacedPart> GroupTool::turned(std::vector<PlacedPart> parts, double by) const {
    Vec2 const centre = centreOf(parts);
    for (PlacedPart& part : parts) {
        part.placement.at = centre + rotated(part.placement.at - centre, by);
        part.placement.angle = tidyAngle(part.placement.angle + by);
    }
    return parts;
}

void GroupTool::turn(int steps, bool fine) {
    if (!any()) {
        return;
    }
    double const by = steps * (fine ? fineTurnStep : turnStep);
    if (dragging()) {
        Vec2 const first = landings_.front().placement.at;
        settle(turned(landings_, by));
        grip_ += landings_.front().placement.at - first;
    } else {
        place(turned(parts(), by));
    }
}

void GroupTool::flip() {
    if (!any()) {
        return;
    }
    std::vector<PlacedPart> wanted = dragging() ? landings_ : parts();
    double const middle = centreOf(wanted).x;
    for (PlacedPart& part : wanted) {
        part.placement = mirroredAcross(part.placement, middle);
    }
    if (dragging()) {
        grip_ += wanted.front().placement.at - landings_.front().placement.at;
        settle(std::move(wanted));
    } else {
        place(wanted);
    }
}

void GroupTool::nudge(Vec2 steps, bool fine) {
    if (any() && !dragging()) {
        place(shifted(parts(), steps * (fine ? gridStep / 5 : gridStep)));
    }
}

void GroupTool::putBack() {
    std::vector<int> const numbers = chosen_;
    reset();
    session_.putBackAll(numbers);
}

void GroupTool::duplicate() {
    std::vector<PlacedPart> originals = parts();
    if (originals.empty() && placing_.selected()) {
        originals.push_back({*placing_.selected(), *placing_.placementOf(*placing_.selected())});
    }
    if (originals.empty() || dragging()) {
        return;
    }
    for (PlacedPart& part : originals) {
        part.number = 0; // a new one
    }
    Verdict first;
    constexpr int farthest = 40; // steps of the grid
    constexpr Vec2 directions[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    for (int step = 2; step <= farthest; step += 2) {
        for (Vec2 const direction : directions) {
            auto const wanted = shifted(originals, direction * (step * gridStep));
            Verdict const verdict = session_.checkAll(wanted);
            if (!verdict.ok) {
                first = first.ok ? verdict : first;
                continue;
            }
            std::vector<Placement> added;
            for (PlacedPart const& part : wanted) {
                added.push_back(part.placement);
            }
            choose(session_.placeAll(added));
            return;
        }
    }
    toasts_.add(words::capital(translated(first.why)), render::ToastKind::Trouble, groupReasonTime);
}

} // namespace trembler::ui
