#include "physics/magnetism/magnetic_effects.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace trembler::magnetic_actions {

double Thing::mostForce(double otherPoles, double otherSusceptibility) const {
    return magneticConstant *
           (poleStrength * (otherPoles + otherSusceptibility) + susceptibility * otherPoles);
}

namespace {

// Among so few things, looking at all is faster than building a tree.
constexpr std::size_t few = 32;

/// m², between the nearest points of two boxes.
double distanceSquared(Bounds const& a, Bounds const& b) {
    double const x = std::max({0.0, a.lower.x - b.upper.x, b.lower.x - a.upper.x});
    double const y = std::max({0.0, a.lower.y - b.upper.y, b.lower.y - a.upper.y});
    return x * x + y * y;
}

/// Adds the force of some sources, all of one object, on one receiver.
void addForce(MagneticPoints const& points, MagneticSum sum, std::size_t receiver, PointRange sources,
              Effect& effect) {
    if (sources.begin == sources.end) {
        return;
    }
    inverse_square::Points const& from = points.sources(sum);
    inverse_square::Points const& on = points.receivers(sum);
    // poleForce() is repulsive for equal signs.
    double const own = -on.weight[receiver] / magneticConstant;
    Vec2 force;
    Vec2 nearest;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = sources.begin; j < sources.end; ++j) {
        Vec2 const r = from.at(j) - on.at(receiver);
        force += poleForce(r, own, from.weight[j]);
        if (lengthSquared(r) < least) {
            least = lengthSquared(r);
            nearest = r;
        }
    }
    double const size = length(force);
    double const along = dot(force, nearest);
    effect.force += size;
    // One pole's force is central.
    bool const several = sources.end - sources.begin > 1;
    effect.along += several && least > 0 ? along / std::sqrt(least) : std::copysign(size, along);
}

Effect effectOf(MagneticPoints const& points, Thing const& on, Thing const& by) {
    Effect effect{by.object};
    for (std::size_t i = on.poles.begin; i < on.poles.end; ++i) {
        addForce(points, MagneticSum::polesOnPoles, i, by.poles, effect);
        addForce(points, MagneticSum::softOnPoles, i, by.soft, effect);
    }
    for (std::size_t i = on.soft.begin; i < on.soft.end; ++i) {
        addForce(points, MagneticSum::polesOnSoft, i, by.poles, effect);
    }
    return effect;
}

} // namespace

void Surroundings::update(MagneticPoints const& points) {
    points_ = &points;
    things_.clear();
    strongest_ = softest_ = 0;
    points.forObjects([&](ObjectId object, PointRange poles, PointRange soft) {
        double const most = std::numeric_limits<double>::max();
        Thing thing{object, poles, soft, {{most, most}, {-most, -most}}, 0, 0};
        inverse_square::Points const& polePoints = points.sources(MagneticSum::polesOnPoles);
        for (std::size_t i = poles.begin; i < poles.end; ++i) {
            thing.bounds.include({polePoints.at(i), polePoints.at(i)});
            thing.poleStrength += std::abs(polePoints.weight[i]);
        }
        inverse_square::Points const& softPoints = points.sources(MagneticSum::softOnPoles);
        for (std::size_t i = soft.begin; i < soft.end; ++i) {
            thing.bounds.include({softPoints.at(i), softPoints.at(i)});
            thing.susceptibility += softPoints.weight[i];
        }
        strongest_ = std::max(strongest_, thing.poleStrength);
        softest_ = std::max(softest_, thing.susceptibility);
        things_.push_back(thing);
    });
    if (things_.size() <= few) {
        tree_.reset();
        near_.resize(things_.size());
        std::iota(near_.begin(), near_.end(), 0U);
        return;
    }
    std::vector<Bounds> boxes;
    boxes.reserve(things_.size());
    for (Thing const& thing : things_) {
        boxes.push_back(thing.bounds);
    }
    tree_.emplace(std::move(boxes));
}

std::vector<Effect>& Surroundings::effectsOn(Thing const& on) {
    effects_.clear();
    if (tree_) {
        double const farthest = on.mostForce(strongest_, softest_) / endForce; // m²
        tree_->findIf([&](Bounds const& box) { return distanceSquared(box, on.bounds) <= farthest; }, near_);
    }
    for (std::uint32_t const i : near_) {
        Thing const& by = things_[i];
        double const most = on.mostForce(by.poleStrength, by.susceptibility);
        bool const acts = most > 0 && most >= endForce * distanceSquared(by.bounds, on.bounds);
        if (acts && by.object != on.object) {
            effects_.push_back(effectOf(*points_, on, by));
        }
    }
    return effects_;
}

} // namespace trembler::magnetic_actions
