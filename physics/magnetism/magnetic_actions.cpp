#include "physics/magnetism/magnetic_actions.hpp"

#include "physics/dynamics/calls.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace trembler {
namespace magnetic_actions {
namespace {

using Action = MagneticForce::Action;

// Less than this share of a force along the line between the two is no reason to call a pull a push.
constexpr double clearlyAlong = 0.1;

/// What one object does to another one: the force, and its part that is directed towards the acting object.
struct Effect {
    ObjectId by;
    double force = 0; ///< N
    double along = 0; ///< N, negative: away
};

/// Adds what each object does to one receiver.
void addEffects(MagneticPoints const& points, MagneticSum sum, std::size_t receiver,
                std::vector<Effect>& effects) {
    inverse_square::Points const& from = points.sources(sum);
    inverse_square::Points const& on = points.receivers(sum);
    std::span<ObjectId const> const objects = points.sourceObjects(sum);
    ObjectId const self = points.receiverObjects(sum)[receiver];
    double const own = -on.weight[receiver] / magneticConstant; // poleForce() is repulsive for equal signs
    for (std::size_t j = 0; j < objects.size();) {
        ObjectId const by = objects[j];
        Vec2 force;
        Vec2 nearest;
        double least = std::numeric_limits<double>::infinity();
        std::size_t const first = j;
        for (; j < objects.size() && objects[j] == by; ++j) {
            Vec2 const r = from.at(j) - on.at(receiver);
            force += poleForce(r, own, from.weight[j]);
            if (lengthSquared(r) < least) {
                least = lengthSquared(r);
                nearest = r;
            }
        }
        if (by == self) {
            continue;
        }
        double const size = length(force);
        double along = std::copysign(size, dot(force, nearest)); // one pole's force is central
        if (j - first > 1 && least > 0) {
            along = dot(force, nearest) / std::sqrt(least);
        }
        effects.push_back({by, size, along});
    }
}

bool byObject(Effect const& a, Effect const& b) {
    return a.by < b.by;
}

/// Adds the effects of the same object, whose points were looked at one by one.
void merge(std::vector<Effect>& effects) {
    if (!std::is_sorted(effects.begin(), effects.end(), byObject)) {
        std::sort(effects.begin(), effects.end(), byObject);
    }
    std::size_t count = 0;
    for (Effect const& effect : effects) {
        if (count > 0 && effects[count - 1].by == effect.by) {
            effects[count - 1].force += effect.force;
            effects[count - 1].along += effect.along;
        } else {
            effects[count++] = effect;
        }
    }
    effects.resize(count);
}

class Follower {
public:
    Follower(MagneticColumns const& columns, std::span<EventId const> switching, RecordEvent const& record,
             std::vector<Action> before)
        : columns_(columns), switching_(switching), record_(record), before_(std::move(before)) {
        now_.reserve(before_.size());
    }

    [[nodiscard]] bool moves(ObjectId object) const { return columns_.velocities.has(object); }

    /// What is done to the next object, in ascending order. May leave out some of the effects.
    void add(ObjectId object, std::vector<Effect>& effects) {
        endBefore(object, ObjectId{0, 0});
        if (effects.size() > mostActions) {
            keepStrongest(object, effects);
        }
        for (Effect const& effect : effects) {
            endBefore(object, effect.by);
            Action const* const before = isNext(object, effect.by) ? &before_[next_++] : nullptr;
            if (rankOf(effect, before != nullptr) > negligibleForce) {
                now_.push_back(actionOf(object, effect, before));
            } else if (before != nullptr) {
                end(*before);
            }
        }
    }

    [[nodiscard]] std::vector<Action> finish() {
        endBefore(ObjectId{}, ObjectId{});
        return std::move(now_);
    }

private:
    /// An action that is followed ends at half of the force at which it began.
    static double rankOf(Effect const& effect, bool followed) {
        return followed ? 2 * effect.force : effect.force;
    }
    [[nodiscard]] bool isNext(ObjectId object, ObjectId by) const {
        return next_ < before_.size() && before_[next_].object == object && before_[next_].by == by;
    }
    /// The actions before this one, and not after those looked at, have ended.
    void endBefore(ObjectId object, ObjectId by) {
        for (; next_ < before_.size(); ++next_) {
            Action const& next = before_[next_];
            if (next.object != object ? object < next.object : by <= next.by) {
                return;
            }
            end(next);
        }
    }
    void keepStrongest(ObjectId object, std::vector<Effect>& effects) const {
        auto const followed = [&](Effect const& effect) {
            auto const at =
                std::find_if(before_.begin() + static_cast<std::ptrdiff_t>(next_), before_.end(),
                             [&](Action const& one) { return one.object != object || one.by == effect.by; });
            return at != before_.end() && at->object == object;
        };
        std::vector<std::pair<double, std::size_t>> ranks;
        for (std::size_t i = 0; i < effects.size(); ++i) {
            ranks.emplace_back(-rankOf(effects[i], followed(effects[i])), i);
        }
        std::sort(ranks.begin(), ranks.end());
        std::vector<Effect> kept;
        for (std::size_t i = 0; i < mostActions; ++i) {
            kept.push_back(effects[ranks[i].second]);
        }
        std::sort(kept.begin(), kept.end(), byObject);
        effects = std::move(kept);
    }

    [[nodiscard]] Action actionOf(ObjectId object, Effect const& effect, Action const* before) const {
        bool const clear = std::abs(effect.along) > clearlyAlong * effect.force;
        bool const push = before != nullptr && !clear ? before->push : effect.along < 0;
        Action made{object, effect.by, effect.force, push, {}};
        if (before != nullptr && before->push == push) {
            made.event = before->event;
        } else {
            made.event = record(push ? magnetic_events::repelled : magnetic_events::attracted, made, true);
        }
        return made;
    }

    void end(Action const& action) const {
        if (columns_.strengths.has(action.object) && columns_.strengths.has(action.by)) { // both still exist
            record(action.push ? magnetic_events::noLongerRepelled : magnetic_events::noLongerAttracted,
                   action, false);
        }
    }

    EventId record(std::string_view what, Action const& action, bool on) const {
        std::array<ObjectId, 2> const objects{action.object, action.by};
        std::array<EventId, 2> causes;
        for (std::size_t i = 0; i < objects.size(); ++i) {
            Magnet const* const magnet = columns_.magnets.find(objects[i]);
            if (magnet != nullptr && magnet->on == on && objects[i].index < switching_.size()) {
                causes[i] = switching_[objects[i].index];
            }
        }
        return record_(what, objects, causes);
    }

    MagneticColumns const& columns_;
    std::span<EventId const> switching_;
    RecordEvent const& record_;
    std::vector<Action> before_;
    std::size_t next_ = 0; // of before_: the first that has not been looked at
    std::vector<Action> now_;
};

} // namespace
} // namespace magnetic_actions

void followActions(MagneticPoints const& points, MagneticColumns const& columns,
                   std::span<EventId const> switching, RecordEvent const& record, MagneticForce& into) {
    using namespace magnetic_actions;
    Follower follower(columns, switching, record, std::move(into.actions));
    std::span<ObjectId const> const poles = points.receiverObjects(MagneticSum::polesOnPoles);
    std::span<ObjectId const> const soft = points.receiverObjects(MagneticSum::polesOnSoft);
    std::vector<Effect> effects;
    for (std::size_t p = 0, s = 0; points.active() && (p < poles.size() || s < soft.size());) {
        bool const both = p < poles.size() && s < soft.size();
        ObjectId const object = both ? std::min(poles[p], soft[s]) : p < poles.size() ? poles[p] : soft[s];
        bool const moves = follower.moves(object);
        effects.clear();
        for (; p < poles.size() && poles[p] == object; ++p) {
            if (moves) {
                addEffects(points, MagneticSum::polesOnPoles, p, effects);
                addEffects(points, MagneticSum::softOnPoles, p, effects);
            }
        }
        for (; s < soft.size() && soft[s] == object; ++s) {
            if (moves) {
                addEffects(points, MagneticSum::polesOnSoft, s, effects);
            }
        }
        if (moves) {
            merge(effects);
            follower.add(object, effects);
        }
    }
    into.actions = follower.finish();
}

void nameCauses(MagneticForce& into) {
    for (MagneticForce::Entry& entry : into.forces) {
        auto const begin =
            std::lower_bound(into.actions.begin(), into.actions.end(), entry.object,
                             [](MagneticForce::Action const& one, ObjectId id) { return one.object < id; });
        MagneticForce::Action const* strongest = nullptr;
        for (auto at = begin; at != into.actions.end() && at->object == entry.object; ++at) {
            if (strongest == nullptr || at->force > strongest->force) {
                strongest = &*at;
            }
        }
        entry.cause = strongest == nullptr ? EventId{} : strongest->event;
    }
}

} // namespace trembler
