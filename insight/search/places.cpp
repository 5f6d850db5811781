#include "insight/search/places.hpp"

#include "insight/search/random_placement.hpp"
#include "insight/search/thing.hpp"
#include "puzzle/goals/model/condition.hpp"
#include "puzzle/goals/read_goals.hpp"
#include "puzzle/session/fit.hpp"
#include "puzzle/session/zone.hpp"
#include "runtime/level/build/placing.hpp"
#include "runtime/level/json/diagnostic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace trembler::insight {
namespace {

using Side = Place::Side;

constexpr double widestGap = 1.5;    // m
constexpr std::size_t mostGaps = 40; // the narrowest
constexpr double clearance = 0.005;  // m, so that touching is no overlap
constexpr double stepAway = 0.05;    // m
constexpr int mostStepsAway = 8;
constexpr double longTop = 0.5; // m: a wider thing has places at its ends as well

class PlaceFinder {
public:
    explicit PlaceFinder(LevelUnderTest const& level) : level_(level), things_(thingsIn(level.world())) {
        for (Area const& area : placingAreas(level)) {
            Outline const box = area.box ? Outline{area.box->corner, area.box->corner + area.box->size}
                                         : outlineOf(area.corners);
            ceiling_ = std::max(ceiling_, box.high.y);
        }
    }

    std::vector<Place> find() {
        addGaps();
        addGoals();
        for (Thing const& thing : things_) {
            if (thing.movable) {
                addAround(thing, Place::Kind::movable);
            }
        }
        for (Thing const& thing : things_) {
            if (thing.magnet) {
                addAround(thing, Place::Kind::magnet);
            }
        }
        for (Thing const& thing : things_) {
            if (thing.liquid) {
                addInside(thing.outline, Place::Kind::liquid, thing.name);
            }
        }
        for (Thing const& thing : things_) {
            if (!thing.movable && !thing.liquid) {
                addOnTop(thing, Place::Kind::fixed);
            }
        }
        return std::move(places_);
    }

private:
    void add(Place place) {
        auto const rounded = [](double metres) { return std::llround(metres * 1000); };
        if (seen_
                .insert({rounded(place.at.x), rounded(place.at.y), static_cast<long long>(place.side),
                         rounded(place.angle)})
                .second) {
            places_.push_back(std::move(place));
        }
    }

    void addGaps() {
        struct Gap {
            double width;
            std::size_t a;
            std::size_t b;
        };
        std::vector<Gap> gaps;
        for (std::size_t a = 0; a < things_.size(); ++a) {
            for (std::size_t b = a + 1; b < things_.size(); ++b) {
                if (things_[a].conductor && things_[b].conductor) {
                    double const width = distance(things_[a].outline, things_[b].outline);
                    if (width > 0 && width <= widestGap) {
                        gaps.push_back({width, a, b});
                    }
                }
            }
        }
        std::stable_sort(gaps.begin(), gaps.end(),
                         [](Gap const& x, Gap const& y) { return x.width < y.width; });
        gaps.resize(std::min(gaps.size(), mostGaps));
        for (Gap const& gap : gaps) {
            Outline const& a = things_[gap.a].outline;
            Outline const& b = things_[gap.b].outline;
            Vec2 const middle = 0.5 * (a.middle() + b.middle());
            Vec2 const along = b.middle() - a.middle();
            std::string const name = things_[gap.a].name + ", " + things_[gap.b].name;
            // Across the gap, lying on both, and in it.
            if (std::abs(along.x) >= std::abs(along.y)) {
                add({Place::Kind::gap, Side::above, {middle.x, std::max(a.high.y, b.high.y)}, 0, name});
                add({Place::Kind::gap, Side::below, {middle.x, std::min(a.low.y, b.low.y)}, 0, name});
            }
            add({Place::Kind::gap, Side::middle, middle, std::atan2(along.y, along.x), name});
        }
    }

    void addGoals() {
        Problems ignored; // the level has been read before
        if (auto const condition = readGoals(level_.level(), ignored)) {
            addGoal(*condition);
        }
    }

    void addGoal(Condition const& condition) {
        for (Selector const* const selector : {&condition.subject, &condition.object}) {
            for (Thing const& thing : things_) {
                bool const named =
                    std::find(selector->names.begin(), selector->names.end(), thing.name) !=
                        selector->names.end() ||
                    (!thing.part.empty() && std::find(selector->parts.begin(), selector->parts.end(),
                                                      thing.part) != selector->parts.end());
                if (named) {
                    addAround(thing, Place::Kind::goal);
                }
            }
        }
        if (condition.area) {
            Area const& area = *condition.area;
            addInside(area.box ? Outline{area.box->corner, area.box->corner + area.box->size}
                               : outlineOf(area.corners),
                      Place::Kind::goal, condition.areaName);
        }
        for (Condition const& child : condition.children) {
            addGoal(child);
        }
    }

    void addOnTop(Thing const& thing, Place::Kind kind) {
        Outline const& box = thing.outline;
        double const width = box.high.x - box.low.x;
        add({kind, Side::above, {box.middle().x, box.high.y}, 0, thing.name});
        if (width > longTop) {
            add({kind, Side::above, {box.low.x + width / 6, box.high.y}, 0, thing.name});
            add({kind, Side::above, {box.high.x - width / 6, box.high.y}, 0, thing.name});
        }
    }

    void addAround(Thing const& thing, Place::Kind kind) {
        Outline const& box = thing.outline;
        addOnTop(thing, kind);
        add({kind, Side::below, {box.middle().x, box.low.y}, 0, thing.name});
        add({kind, Side::left, {box.low.x, box.middle().y}, 0, thing.name});
        add({kind, Side::right, {box.high.x, box.middle().y}, 0, thing.name});
        if (box.high.y < ceiling_) { // to be dropped on it
            add({kind, Side::below, {box.middle().x, ceiling_}, 0, thing.name});
        }
    }

    void addInside(Outline const& box, Place::Kind kind, std::string const& name) {
        Vec2 const size = box.high - box.low;
        for (int row = 1; row <= 3; ++row) {
            for (int column = 1; column <= 5; ++column) {
                add({kind, Side::middle, box.low + Vec2{size.x * column / 6.0, size.y * row / 4.0}, 0, name});
            }
        }
    }

    LevelUnderTest const& level_;
    std::vector<Thing> things_;
    double ceiling_ = -std::numeric_limits<double>::infinity();
    std::vector<Place> places_;
    std::set<std::array<long long, 4>> seen_;
};

/// The nearest place at which the part lies wholly in one of the areas that are rectangles; its own place if
/// it lies inside already, or if it is too large for all of them. `outline`: that of the part at (0, 0).
Vec2 nearestAllowed(LevelUnderTest const& level, Placement const& placement, Outline const& outline) {
    if (!whyItSticksOut(level.level(), level.data().parts, placement)) {
        return placement.at;
    }
    double best = std::numeric_limits<double>::infinity();
    Vec2 nearest = placement.at;
    for (Area const& area : placingAreas(level)) {
        if (!area.box) {
            continue;
        }
        Vec2 const low = area.box->corner - outline.low;
        Vec2 const high = area.box->corner + area.box->size - outline.high;
        if (low.x > high.x || low.y > high.y) {
            continue;
        }
        Vec2 const inside{std::clamp(placement.at.x, low.x, high.x),
                          std::clamp(placement.at.y, low.y, high.y)};
        if (lengthSquared(inside - placement.at) < best) {
            best = lengthSquared(inside - placement.at);
            nearest = inside;
        }
    }
    return nearest;
}

} // namespace

std::vector<Place> placesOfInterest(LevelUnderTest const& level) {
    return PlaceFinder(level).find();
}

std::optional<Placement> placedAt(LevelUnderTest const& level, Place const& place, std::string const& part,
                                  double turn) {
    Placement placement;
    placement.part = part;
    placement.angle = place.angle + turn;
    std::optional<Outline> const outline = outlineOf(level.data().parts, placement);
    if (!outline) {
        return std::nullopt;
    }
    Vec2 const middle = outline->middle();
    Vec2 away{0, 1};
    placement.at = place.at - middle;
    switch (place.side) {
    case Side::above:
        placement.at.y = place.at.y - outline->low.y + clearance;
        break;
    case Side::below:
        placement.at.y = place.at.y - outline->high.y - clearance;
        away = {0, -1};
        break;
    case Side::left:
        placement.at.x = place.at.x - outline->high.x - clearance;
        away = {-1, 0};
        break;
    case Side::right:
        placement.at.x = place.at.x - outline->low.x + clearance;
        away = {1, 0};
        break;
    case Side::middle:
        break;
    }
    placement.at = nearestAllowed(level, placement, *outline);
    for (int step = 0; step <= mostStepsAway; ++step) {
        PlacementCount count(level.level(), level.data().parts);
        if (!count.add(placement) && !whyItSticksOut(level.level(), level.data().parts, placement) &&
            !whyItDoesNotFit(level.world(), level.data().parts, placement, {})) {
            return placement;
        }
        placement.at += stepAway * away;
    }
    return std::nullopt;
}

} // namespace trembler::insight
