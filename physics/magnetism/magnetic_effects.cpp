#include "physics/magnetism/magnetic_effects.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace trembler::magnetic_actions {

void Thing::addPoint(Vec2 at) {
    left = std::min(left, at.x);
    right = std::max(right, at.x);
    bottom = std::min(bottom, at.y);
    top = std::max(top, at.y);
}

double Thing::mostForce(double otherPoles, double otherSusceptibility) const {
    return magneticConstant *
           (poleStrength * (otherPoles + otherSusceptibility) + susceptibility * otherPoles);
}

namespace {

// Among so few things, looking at all is faster than sorting.
constexpr std::size_t few = 32;

/// Adds the force of sources from `begin` to `end`, all of one object, on one receiver.
void addForce(MagneticPoints const& points, MagneticSum sum, std::size_t receiver, std::size_t begin,
              std::size_t end, Effect& effect) {
    if (begin == end) {
        return;
    }
    inverse_square::Points const& from = points.sources(sum);
    inverse_square::Points const& on = points.receivers(sum);
    // poleForce() is repulsive for equal signs.
    double const own = -on.weight[receiver] / magneticConstant;
    Vec2 force;
    Vec2 nearest;
    double least = unbounded;
    for (std::size_t j = begin; j < end; ++j) {
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
    effect.along += end - begin > 1 && least > 0 ? along / std::sqrt(least) : std::copysign(size, along);
}

Effect effectOf(MagneticPoints const& points, Thing const& on, Thing const& by) {
    Effect effect{by.object};
    for (std::size_t p = on.pole; p < on.polesEnd; ++p) {
        addForce(points, MagneticSum::polesOnPoles, p, by.pole, by.polesEnd, effect);
        addForce(points, MagneticSum::softOnPoles, p, by.soft, by.softEnd, effect);
    }
    for (std::size_t s = on.soft; s < on.softEnd; ++s) {
        addForce(points, MagneticSum::polesOnSoft, s, by.pole, by.polesEnd, effect);
    }
    return effect;
}

} // namespace

void Surroundings::gatherThings() {
    std::span<ObjectId const> const poles = points_->sourceObjects(MagneticSum::polesOnPoles);
    std::span<ObjectId const> const soft = points_->sourceObjects(MagneticSum::softOnPoles);
    inverse_square::Points const& polePoints = points_->sources(MagneticSum::polesOnPoles);
    inverse_square::Points const& softPoints = points_->sources(MagneticSum::softOnPoles);
    things_.clear();
    for (std::size_t p = 0, s = 0; p < poles.size() || s < soft.size();) {
        bool const both = p < poles.size() && s < soft.size();
        Thing thing;
        thing.object = both ? std::min(poles[p], soft[s]) : p < poles.size() ? poles[p] : soft[s];
        for (thing.pole = p; p < poles.size() && poles[p] == thing.object; ++p) {
            thing.addPoint(polePoints.at(p));
            thing.poleStrength += std::abs(polePoints.weight[p]);
        }
        for (thing.soft = s; s < soft.size() && soft[s] == thing.object; ++s) {
            thing.addPoint(softPoints.at(s));
            thing.susceptibility += softPoints.weight[s];
        }
        thing.polesEnd = p;
        thing.softEnd = s;
        things_.push_back(thing);
    }
}

void Surroundings::update(MagneticPoints const& points) {
    points_ = &points;
    gatherThings();
    fromTheLeft_.clear();
    if (things_.size() <= few) {
        return;
    }
    fromTheLeft_.resize(things_.size());
    std::iota(fromTheLeft_.begin(), fromTheLeft_.end(), std::size_t{0});
    std::sort(fromTheLeft_.begin(), fromTheLeft_.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(things_[a].left, a) < std::pair(things_[b].left, b);
    });
    widest_ = strongest_ = softest_ = 0;
    for (Thing const& thing : things_) {
        widest_ = std::max(widest_, thing.right - thing.left);
        strongest_ = std::max(strongest_, thing.poleStrength);
        softest_ = std::max(softest_, thing.susceptibility);
    }
}

void Surroundings::consider(Thing const& on, std::size_t other) {
    Thing const& by = things_[other];
    double const x = std::max({0.0, by.left - on.right, on.left - by.right});
    double const y = std::max({0.0, by.bottom - on.top, on.bottom - by.top});
    double const most = on.mostForce(by.poleStrength, by.susceptibility);
    if (most > 0 && most >= endForce * (x * x + y * y) && by.object != on.object) {
        near_.push_back(other);
    }
}

std::vector<Effect>& Surroundings::effectsOn(Thing const& on) {
    near_.clear();
    effects_.clear();
    if (fromTheLeft_.empty()) {
        for (std::size_t i = 0; i < things_.size(); ++i) {
            consider(on, i);
        }
    } else {
        double const reach = std::sqrt(on.mostForce(strongest_, softest_) / endForce);
        auto at = std::partition_point(fromTheLeft_.begin(), fromTheLeft_.end(), [&](std::size_t i) {
            return things_[i].left < on.left - reach - widest_;
        });
        for (; at != fromTheLeft_.end() && things_[*at].left <= on.right + reach; ++at) {
            consider(on, *at);
        }
        std::sort(near_.begin(), near_.end());
    }
    for (std::size_t const i : near_) {
        effects_.push_back(effectOf(*points_, on, things_[i]));
    }
    return effects_;
}

} // namespace trembler::magnetic_actions
