#include "physics/magnetism/magnetic_actions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace trembler {
namespace magnetic_actions {
namespace {

using Action = MagneticForce::Action;

// Less than this share of a force along the line between the two is no reason to call a pull a push.
constexpr double clearlyAlong = 0.1;

bool byObject(Effect const& a, Effect const& b) {
    return a.by < b.by;
}

class Follower {
public:
    Follower(MagneticColumns const& columns, std::span<EventId const> switching, RecordEvent const& record,
             std::span<Action const> before, std::vector<Action>& now)
        : columns_(columns), switching_(switching), record_(record), before_(before), now_(now) {}

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

    void finish() { endBefore(ObjectId{}, ObjectId{}); }

private:
    /// A followed action's is larger, so that it ends at a smaller force than that at which it began.
    static double rankOf(Effect const& effect, bool followed) {
        return followed ? negligibleForce / endForce * effect.force : effect.force;
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
    std::span<Action const> before_;
    std::size_t next_ = 0; // of before_: the first that has not been looked at
    std::vector<Action>& now_;
};

void listStrongest(std::span<Action const> actions, std::vector<std::pair<ObjectId, EventId>>& strongest) {
    strongest.clear();
    double force = 0;
    for (Action const& action : actions) {
        bool const another = strongest.empty() || strongest.back().first != action.object;
        if (another) {
            strongest.emplace_back(action.object, action.event);
        } else if (action.force > force) {
            strongest.back().second = action.event;
        } else {
            continue;
        }
        force = action.force;
    }
}

bool differ(inverse_square::Points const& a, inverse_square::Points const& b) {
    if (a.weight != b.weight || a.owner != b.owner) {
        return true;
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (lengthSquared(a.at(i) - b.at(i)) > followDistance * followDistance) {
            return true;
        }
    }
    return false;
}

} // namespace
} // namespace magnetic_actions

void MagneticActions::follow(MagneticPoints const& points, MagneticColumns const& columns,
                             std::span<EventId const> switching, RecordEvent const& record,
                             MagneticForce& into) {
    using namespace magnetic_actions;
    before_.swap(into.actions);
    into.actions.clear();
    Follower follower(columns, switching, record, before_, into.actions);
    if (points.active()) {
        surroundings_.update(points);
        for (Thing const& thing : surroundings_.things()) {
            if (follower.moves(thing.object)) {
                follower.add(thing.object, surroundings_.effectsOn(thing));
            }
        }
    }
    follower.finish();
    poles_ = points.sources(MagneticSum::polesOnPoles);
    soft_ = points.sources(MagneticSum::softOnPoles);
    listStrongest(into.actions, strongest_);
}

bool MagneticActions::outdated(MagneticPoints const& points) const {
    return magnetic_actions::differ(poles_, points.sources(MagneticSum::polesOnPoles)) ||
           magnetic_actions::differ(soft_, points.sources(MagneticSum::softOnPoles));
}

void MagneticActions::nameCauses(MagneticForce& into) const {
    auto at = strongest_.begin();
    for (MagneticForce::Entry& entry : into.forces) {
        while (at != strongest_.end() && at->first < entry.object) {
            ++at;
        }
        bool const any = at != strongest_.end() && at->first == entry.object;
        entry.cause = any ? at->second : EventId{};
    }
}

} // namespace trembler
