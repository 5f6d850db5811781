#include "insight/search/mutation.hpp"

#include "insight/search/random_placement.hpp"
#include "insight/search/wire_ends.hpp"
#include "insight/trial/solution_text.hpp"
#include "insight/trial/trial.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace trembler::insight {
namespace {

constexpr std::size_t mostPlacedParts = 8;
constexpr int changesTried = 12;
constexpr std::size_t mostCombined = 4; // parts
constexpr double combinedByChance = 0.5;
constexpr double addedByChance = 0.2;
constexpr double addedWhereLacking = 0.5;
constexpr std::array<double, 7> moveScales{0.01, 0.02, 0.05, 0.1, 0.2, 0.4, 0.8}; // m
constexpr std::array<double, 6> turnScales{2, 5, 15, 45, 90, 180};                // degrees

/// Of n parents the first twice as often as one in the middle.
Parent const& oneOf(std::span<Parent const> parents, CounterRandom& random) {
    std::size_t const a = random.below(parents.size());
    std::size_t const b = random.below(parents.size());
    return parents[std::min(a, b)];
}

/// Across one of the gaps, or on one of the ways that were left.
Place placeIn(std::vector<Lacking> const& lacking, CounterRandom& random) {
    constexpr std::array<Place::Side, 4> sides{Place::Side::above, Place::Side::above, Place::Side::middle,
                                               Place::Side::below};
    Lacking const& one = lacking[random.below(lacking.size())];
    Vec2 const way = one.to - one.from;
    Place place;
    place.kind = one.isGap ? Place::Kind::gap : Place::Kind::goal;
    place.side = sides[random.below(sides.size())];
    place.at = one.from + (one.isGap ? 0.5 : random.unit()) * way;
    if (place.side == Place::Side::middle && length(way) > 0) {
        place.angle = std::atan2(way.y, way.x);
    }
    return place;
}

/// Mostly upright, else in steps of 15 degrees.
double anyTurn(CounterRandom& random) {
    return random.chance(0.7) ? 0 : static_cast<double>(random.below(12)) * pi / 12;
}

std::vector<std::string> partsLeft(LevelUnderTest const& level, Solution const& solution) {
    std::vector<std::string> left;
    for (ToolboxEntry const& entry : level.level().toolbox) {
        if (leftInToolbox(level, solution, entry.part) > 0) {
            left.push_back(entry.part);
        }
    }
    return left;
}

} // namespace

Mutator::Mutator(LevelUnderTest const& level, bool hands)
    : level_(level), hands_(hands), places_(placesOfInterest(level)), things_(thingsIn(level.world())) {
    std::map<Place::Kind, std::vector<std::size_t>> kinds;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        kinds[places_[i].kind].push_back(i);
    }
    for (auto& [kind, places] : kinds) {
        byKind_.push_back(std::move(places));
    }
}

Place const& Mutator::anyPlace(CounterRandom& random) const {
    std::vector<std::size_t> const& kind = byKind_[random.below(byKind_.size())];
    return places_[kind[random.below(kind.size())]];
}

std::optional<Placement> Mutator::placedSomewhere(Solution const& others, std::string const& part,
                                                  double byChance, CounterRandom& random) const {
    if (places_.empty() || random.chance(byChance)) {
        return placedAtRandom(level_, others, part, random);
    }
    double const turn = anyTurn(random);
    return placedAt(level_, anyPlace(random), part, turn);
}

Solution Mutator::combined(CounterRandom& random) const {
    Solution solution;
    std::size_t const count = 1 + random.below(mostCombined);
    for (std::size_t n = 0; n < count; ++n) {
        std::vector<std::string> const left = partsLeft(level_, solution);
        if (left.empty()) {
            break;
        }
        std::string const& part = left[random.below(left.size())];
        if (auto const placement = placedSomewhere(solution, part, combinedByChance, random)) {
            solution.placements.push_back(*placement);
            if (n > 0 && whyNotPlaced(level_, solution)) {
                solution.placements.pop_back();
            }
        }
    }
    addRandomWires(level_, solution, random);
    return solution;
}

Attempt Mutator::changed(std::span<Parent const> parents, Tried const& tried, CounterRandom& random) const {
    for (int n = 0; n < changesTried; ++n) {
        Parent const& parent = oneOf(parents, random);
        Solution made = parent.solution;
        changeOnce(made, parent, parents, random);
        while (random.chance(0.3)) {
            changeOnce(made, parent, parents, random);
        }
        if (!tried.contains(identityOf(made)) && !whyNotPlaced(level_, made)) {
            return {std::move(made), parent.run};
        }
    }
    return {combined(random), 0};
}

void Mutator::changeOnce(Solution& solution, Parent const& parent, std::span<Parent const> parents,
                         CounterRandom& random) const {
    double const which = random.unit();
    if (which < 0.12 && hands_) {
        if (random.chance(0.3) || !addRandomDeed(level_, things_, places_, solution, random)) {
            removeRandomDeed(solution, random);
        }
    } else if (which < 0.2 && level_.level().wires > 0) {
        if (random.chance(0.4) && !solution.wires.empty()) {
            solution.wires.erase(solution.wires.begin() +
                                 static_cast<std::ptrdiff_t>(random.below(solution.wires.size())));
        } else {
            addRandomWire(level_, solution, random);
        }
    } else if (which < 0.45 || solution.placements.empty()) {
        addPart(solution, parent, random);
    } else if (which < 0.7) {
        movePart(solution, random);
    } else if (which < 0.78) {
        turnPart(solution, random);
    } else if (which < 0.86) {
        exchangePart(solution, random);
    } else if (which < 0.94) {
        takeOver(solution, oneOf(parents, random), random);
    } else {
        solution.placements.erase(solution.placements.begin() +
                                  static_cast<std::ptrdiff_t>(random.below(solution.placements.size())));
    }
}

void Mutator::movePart(Solution& solution, CounterRandom& random) const {
    Placement& placement = solution.placements[random.below(solution.placements.size())];
    if (random.chance(0.25) && !places_.empty()) { // to another place altogether
        if (auto const there = placedAt(level_, anyPlace(random), placement.part, placement.angle)) {
            placement.at = there->at;
        }
        return;
    }
    double const scale = moveScales[random.below(moveScales.size())];
    placement.at += scale * Vec2{random.between(-1, 1), random.between(-1, 1)};
}

void Mutator::turnPart(Solution& solution, CounterRandom& random) {
    Placement& placement = solution.placements[random.below(solution.placements.size())];
    if (random.chance(0.25)) {
        placement.flipped = !placement.flipped;
        return;
    }
    double const degrees = turnScales[random.below(turnScales.size())];
    placement.angle += (random.chance(0.5) ? degrees : -degrees) * pi / 180;
}

void Mutator::addPart(Solution& solution, Parent const& parent, CounterRandom& random) const {
    std::vector<std::string> const left = partsLeft(level_, solution);
    if (left.empty() || solution.placements.size() >= mostPlacedParts) {
        return;
    }
    std::string const& part = left[random.below(left.size())];
    std::optional<Placement> placement;
    if (!parent.lacking.empty() && random.chance(addedWhereLacking)) {
        double const turn = anyTurn(random);
        placement = placedAt(level_, placeIn(parent.lacking, random), part, turn);
    } else {
        placement = placedSomewhere(solution, part, addedByChance, random);
    }
    if (placement) {
        solution.placements.push_back(*placement);
    }
}

void Mutator::exchangePart(Solution& solution, CounterRandom& random) const {
    std::vector<std::string> const left = partsLeft(level_, solution);
    if (!left.empty()) {
        solution.placements[random.below(solution.placements.size())].part = left[random.below(left.size())];
    }
}

void Mutator::takeOver(Solution& solution, Parent const& other, CounterRandom& random) const {
    if (other.solution.placements.empty()) {
        return;
    }
    Placement const& one = other.solution.placements[random.below(other.solution.placements.size())];
    if (leftInToolbox(level_, solution, one.part) > 0 && solution.placements.size() < mostPlacedParts) {
        solution.placements.push_back(one);
    }
}

} // namespace trembler::insight
