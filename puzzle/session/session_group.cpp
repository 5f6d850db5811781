// Edits of several placed parts in one step.
#include "puzzle/session/fit.hpp"
#include "puzzle/session/session.hpp"
#include "puzzle/session/zone.hpp"
#include "runtime/level/build/placing.hpp"

#include <algorithm>

namespace trembler {

Verdict Session::checkAll(std::span<PlacedPart const> moved) const {
    std::vector<Placement> others;
    std::vector<ObjectId> ignored;
    for (PlacedPart const& part : placed()) {
        bool const moves = std::any_of(moved.begin(), moved.end(),
                                       [&](PlacedPart const& one) { return one.number == part.number; });
        if (moves) {
            std::vector<ObjectId> const pieces = objectsOf(part.number);
            ignored.insert(ignored.end(), pieces.begin(), pieces.end());
        } else {
            others.push_back(part.placement);
        }
    }
    for (PlacedPart const& part : moved) {
        auto why = checkPlacement(level_, parts_, others, part.placement);
        if (!why) {
            why = whyItSticksOut(level_, parts_, part.placement);
        }
        if (!why) {
            why = whyItDoesNotFit(world(), parts_, part.placement, ignored);
        }
        if (why) {
            return {false, *why};
        }
        others.push_back(part.placement);
    }
    return {};
}

bool Session::moveAll(std::span<PlacedPart const> moved) {
    if (!building() || moved.empty() || !checkAll(moved).ok) {
        return false;
    }
    Placements::List next = placed();
    for (PlacedPart const& part : moved) {
        auto const index = placements_.indexOf(part.number);
        if (!index) {
            return false;
        }
        next[*index].placement = part.placement;
    }
    return keep(std::move(next));
}

bool Session::putBackAll(std::span<int const> numbers) {
    if (!building()) {
        return false;
    }
    Placements::List next = placed();
    auto const chosen = [&](PlacedPart const& part) {
        return std::find(numbers.begin(), numbers.end(), part.number) != numbers.end();
    };
    bool const any = std::erase_if(next, chosen) > 0;
    return any && keep(std::move(next));
}

std::vector<int> Session::placeAll(std::span<Placement const> added) {
    std::vector<PlacedPart> asked;
    for (Placement const& placement : added) {
        asked.push_back({0, placement}); // no placed part has this number
    }
    if (!building() || added.empty() || !checkAll(asked).ok) {
        return {};
    }
    Placements::List next = placements_.withAll(added);
    std::vector<int> numbers;
    for (auto part = next.end() - static_cast<std::ptrdiff_t>(added.size()); part != next.end(); ++part) {
        numbers.push_back(part->number);
    }
    return keep(std::move(next)) ? numbers : std::vector<int>{};
}

} // namespace trembler
