#include "game/ui/play/view/squash_view.hpp"

#include "render/scene/facts/facts.hpp"
#include "render/scene/facts/pick.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::ui {
namespace {

constexpr double squashDepth = 0.16; // share of the height, at the beginning
constexpr double squashFades = 9;    // 1/s
constexpr double squashSwings = 24;  // rad/s

bool liesThere(std::vector<PlacedPart> const& all, PlacedPart const& part) {
    return std::any_of(all.begin(), all.end(), [&](PlacedPart const& other) {
        return other.number == part.number && other.placement.at == part.placement.at &&
               other.placement.angle == part.placement.angle &&
               other.placement.flipped == part.placement.flipped;
    });
}

} // namespace

void SquashView::look(Session const& session, double seconds, bool wanted) {
    age_ += seconds;
    if (age_ > life || session.mode() != SessionMode::building) {
        numbers_.clear();
    }
    if (session.mode() != SessionMode::building) {
        return;
    }
    std::vector<int> placed;
    for (PlacedPart const& part : session.placed()) {
        if (!liesThere(before_, part)) {
            placed.push_back(part.number);
        }
    }
    if (known_ && wanted && !placed.empty()) {
        numbers_ = std::move(placed);
        age_ = 0;
    }
    before_ = session.placed();
    known_ = true;
}

std::vector<ObjectId> SquashView::objects(Session const& session) const {
    std::vector<ObjectId> all;
    for (int const number : numbers_) {
        auto const pieces = session.objectsOf(number);
        all.insert(all.end(), pieces.begin(), pieces.end());
    }
    return all;
}

render::Flattening SquashView::flattening(Session const& session) const {
    if (numbers_.empty()) {
        return {};
    }
    render::FactsReader const reader(session.world());
    render::Extent extent;
    for (ObjectId const object : objects(session)) {
        render::Facts const facts = reader.of(object);
        if (facts.shape != nullptr) {
            extent.add(render::extentOf(facts, render::poseOf(session.world(), object)));
        }
    }
    double const by = squashDepth * std::exp(-squashFades * age_) * std::cos(squashSwings * age_);
    return {
        {extent.empty() ? 0 : extent.centre().x, extent.empty() ? 0 : extent.lower.y}, 1 + 0.7 * by, 1 - by};
}

} // namespace trembler::ui
