#include "puzzle/goals/condition_state.hpp"

#include "physics/dynamics/properties/contacts.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/magnetism/properties.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace trembler {
namespace {

/// The contact of two objects, or nullptr.
TouchingPair const* findPair(std::vector<TouchingPair> const& pairs, ObjectId a, ObjectId b) {
    TouchingPair const wanted{std::min(a, b), std::max(a, b), {}};
    auto const at = std::lower_bound(pairs.begin(), pairs.end(), wanted);
    return at != pairs.end() && *at == wanted ? &*at : nullptr;
}

Vec2 directionOf(Towards towards) {
    switch (towards) {
    case Towards::up:
        return {0, 1};
    case Towards::down:
        return {0, -1};
    case Towards::left:
        return {-1, 0};
    case Towards::right:
        return {1, 0};
    case Towards::anywhere:
        break;
    }
    return {};
}

bool isOn(World const& world, ObjectId id) {
    auto const* const state = world.find<ElectricalState>();
    return state != nullptr && state->isOn(id);
}

/// Calls f(a, b, pair) for every contact of one of `as` with another one of `bs`, both of which are
/// ascending. Looks each two of them up, or each contact, whichever is less.
template <class F>
void forContacts(std::vector<TouchingPair> const& pairs, std::vector<ObjectId> const& as,
                 std::vector<ObjectId> const& bs, F&& f) {
    if (bs.empty() || as.size() <= pairs.size() / bs.size()) {
        for (ObjectId const a : as) {
            for (ObjectId const b : bs) {
                if (TouchingPair const* const pair = findPair(pairs, a, b)) {
                    f(a, b, *pair);
                }
            }
        }
        return;
    }
    auto const isOneOf = [](std::vector<ObjectId> const& all, ObjectId id) {
        return std::binary_search(all.begin(), all.end(), id);
    };
    for (TouchingPair const& pair : pairs) {
        if (isOneOf(as, pair.a) && isOneOf(bs, pair.b)) {
            f(pair.a, pair.b, pair);
        }
        if (isOneOf(as, pair.b) && isOneOf(bs, pair.a)) {
            f(pair.b, pair.a, pair);
        }
    }
}

/// What acts on objects, which are ascending, at present: what they touch, and which magnets pull them.
void collectActing(World const& world, std::vector<ObjectId> const& ids, std::vector<EventId>& events) {
    auto const isOne = [&](ObjectId id) { return std::binary_search(ids.begin(), ids.end(), id); };
    if (auto const* const contacts = world.find<Contacts>()) {
        for (TouchingPair const& pair : contacts->current) {
            if (isOne(pair.a) || isOne(pair.b)) {
                events.push_back(pair.event);
            }
        }
    }
    if (auto const* const magnetic = world.find<MagneticForce>()) {
        for (MagneticForce::Entry const& entry : magnetic->forces) {
            if (isOne(entry.object)) {
                events.push_back(entry.cause);
            }
        }
    }
}

} // namespace

ConditionState::ConditionState(Condition const& condition, ObjectFinder const& finder, ObjectId it)
    : condition_(&condition), subjects_(finder.find(condition.subject, it)),
      objects_(finder.find(condition.object, it)),
      needed_(condition.seconds
                  ? World::ticksPerFrame * static_cast<std::uint64_t>(
                                               std::max(1L, std::lround(*condition.seconds / frameDuration)))
                  : 1) {
    constexpr std::size_t own = 8; // a condition takes about as much memory as so many objects
    if (!finder.take(own + subjects_.size() + objects_.size(), condition.path)) {
        subjects_.clear();
        objects_.clear();
        return;
    }
    switch (condition.kind) {
    case ConditionKind::inside:
    case ConditionKind::moved:
        finder.mustHave(condition.subject, propertyInfo<Position>(),
                        "is nowhere, so it can never get anywhere");
        for (ObjectId const id : subjects_) {
            Position const* const position = finder.world().find<Position>(id);
            starts_.push_back(position == nullptr ? Vec2{} : position->value);
        }
        break;
    case ConditionKind::touching:
        finder.mustHave(condition.subject, propertyInfo<Shape>(),
                        "has no shape, so it can never touch anything");
        finder.mustHave(condition.object, propertyInfo<Shape>(),
                        "has no shape, so it can never touch anything");
        break;
    case ConditionKind::on:
    case ConditionKind::off:
        finder.mustHave(condition.subject, propertyInfo<Conductor>(), "is no conductor, so it is never on");
        break;
    case ConditionKind::count:
        for (ObjectId const member : subjects_) {
            if (!finder.take(0, condition.path)) {
                break;
            }
            for (Condition const& child : condition.children) {
                children_.emplace_back(child, finder, member);
            }
        }
        return;
    case ConditionKind::all:
    case ConditionKind::any:
    case ConditionKind::negation:
    case ConditionKind::sequence:
        break;
    }
    for (Condition const& child : condition.children) {
        children_.emplace_back(child, finder, it);
    }
}

void ConditionState::restart() {
    held_ = 0;
    for (ConditionState& child : children_) {
        child.restart();
    }
}

void ConditionState::update(World const& world, std::uint64_t ticks) {
    for (ConditionState& child : children_) {
        child.update(world, ticks);
    }
    base_ = holds(world);
    held_ = base_ ? std::min(held_ + ticks, needed_) : 0;
    met_ = held_ >= needed_;
    if (needed_ > World::ticksPerFrame && base_) {
        progress_ = static_cast<double>(held_) / static_cast<double>(needed_);
    }
}

bool ConditionState::holds(World const& world) {
    progress_ = 0;
    switch (condition_->kind) {
    case ConditionKind::inside:
        return inside(world);
    case ConditionKind::touching:
        return touching(world);
    case ConditionKind::on:
        return std::any_of(subjects_.begin(), subjects_.end(), [&](ObjectId id) { return isOn(world, id); });
    case ConditionKind::off:
        return std::any_of(subjects_.begin(), subjects_.end(),
                           [&](ObjectId id) { return world.store().alive(id) && !isOn(world, id); });
    case ConditionKind::moved:
        return moved(world);
    case ConditionKind::count:
        return counted();
    case ConditionKind::all:
        for (ConditionState const& child : children_) {
            progress_ += child.progress() / static_cast<double>(children_.size());
        }
        return std::all_of(children_.begin(), children_.end(),
                           [](ConditionState const& c) { return c.met(); });
    case ConditionKind::any:
        for (ConditionState const& child : children_) {
            progress_ = std::max(progress_, child.progress());
        }
        return std::any_of(children_.begin(), children_.end(),
                           [](ConditionState const& c) { return c.met(); });
    case ConditionKind::negation:
        return !children_.empty() && !children_.front().met();
    case ConditionKind::sequence:
        advanceSequence(world);
        return steps_ == children_.size();
    }
    return false;
}

bool ConditionState::inside(World const& world) {
    return std::any_of(subjects_.begin(), subjects_.end(), [&](ObjectId id) {
        Position const* const position = world.find<Position>(id);
        return position != nullptr && condition_->area.contains(position->value);
    });
}

bool ConditionState::touching(World const& world) {
    auto const* const contacts = world.find<Contacts>();
    if (contacts == nullptr) {
        return false;
    }
    // A hit that is over within the frame is a touch, too.
    bool any = false;
    forContacts(contacts->current, subjects_, objects_,
                [&](ObjectId, ObjectId, TouchingPair const&) { any = true; });
    // What ended last, by the order of the objects.
    std::pair<ObjectId, ObjectId> last;
    TouchingPair const* ended = nullptr;
    auto const note = [&](ObjectId a, ObjectId b, TouchingPair const& pair) {
        if (ended == nullptr || std::pair(a, b) >= last) {
            last = {a, b};
            ended = &pair;
        }
    };
    forContacts(contacts->ended, subjects_, objects_, note);
    forContacts(contacts->brief, subjects_, objects_, [&](ObjectId a, ObjectId b, TouchingPair const& pair) {
        any = true;
        note(a, b, pair);
    });
    if (ended != nullptr) {
        ended_ = ended->event;
    }
    return any;
}

double ConditionState::wayOf(World const& world, std::size_t subject) const {
    Position const* const position = world.find<Position>(subjects_[subject]);
    if (position == nullptr) {
        return 0; // gone
    }
    Vec2 const way = position->value - starts_[subject];
    return condition_->towards == Towards::anywhere ? length(way)
                                                    : dot(way, directionOf(condition_->towards));
}

bool ConditionState::moved(World const& world) {
    double farthest = 0;
    for (std::size_t i = 0; i < subjects_.size(); ++i) {
        farthest = std::max(farthest, wayOf(world, i));
    }
    progress_ = std::clamp(farthest / condition_->distance, 0.0, 1.0);
    return farthest >= condition_->distance;
}

bool ConditionState::counted() {
    auto const number = static_cast<int>(
        std::count_if(children_.begin(), children_.end(), [](ConditionState const& c) { return c.met(); }));
    int const wanted = condition_->number;
    if (condition_->quantity != Quantity::atMost && wanted > 0) {
        progress_ = std::min(1.0, static_cast<double>(number) / wanted);
    }
    switch (condition_->quantity) {
    case Quantity::atLeast:
        return number >= wanted;
    case Quantity::atMost:
        return number <= wanted;
    case Quantity::exactly:
        return number == wanted;
    }
    return false;
}

// "First the bell, then the lamp" is not met by a lamp that was lit before: a step has to begin after the one
// before it was done. If it already holds when its turn comes, it must cease first.
void ConditionState::advanceSequence(World const& world) {
    if (steps_ < children_.size()) {
        ConditionState& step = children_[steps_];
        blocked_ = blocked_ && step.base_;
        if (!blocked_ && step.met()) {
            step.collectCauses(world, true, stepCauses_);
            ++steps_;
            if (steps_ < children_.size()) {
                blocked_ = children_[steps_].base_;
                children_[steps_].restart();
            }
        }
    }
    auto const count = static_cast<double>(children_.size());
    double const now = steps_ < children_.size() && !blocked_ ? children_[steps_].progress() : 0;
    progress_ = (static_cast<double>(steps_) + std::min(now, 1.0)) / count;
}

void ConditionState::collectContacts(World const& world, bool truth, std::vector<EventId>& events) const {
    if (!truth) {
        events.push_back(ended_);
        return;
    }
    if (auto const* const contacts = world.find<Contacts>()) {
        std::set<std::pair<ObjectId, ObjectId>> lasting;
        forContacts(contacts->current, subjects_, objects_,
                    [&](ObjectId a, ObjectId b, TouchingPair const& pair) {
                        lasting.emplace(a, b);
                        events.push_back(pair.event);
                    });
        forContacts(contacts->brief, subjects_, objects_,
                    [&](ObjectId a, ObjectId b, TouchingPair const& pair) {
                        if (!lasting.contains({a, b})) {
                            events.push_back(pair.event);
                        }
                    });
    }
}

void ConditionState::collectCauses(World const& world, bool truth, std::vector<EventId>& events) const {
    switch (condition_->kind) {
    case ConditionKind::inside:
    case ConditionKind::moved:
        collectActing(world, subjects_, events);
        break;
    case ConditionKind::touching:
        collectContacts(world, truth, events);
        break;
    case ConditionKind::on:
    case ConditionKind::off:
        if (auto const* const state = world.find<ElectricalState>()) {
            for (ObjectId const id : subjects_) {
                if (state->isOn(id) == ((condition_->kind == ConditionKind::on) == truth)) {
                    events.push_back(state->eventOf(id));
                }
            }
        }
        break;
    case ConditionKind::negation:
        for (ConditionState const& child : children_) {
            child.collectCauses(world, !truth, events);
        }
        break;
    case ConditionKind::sequence:
        events.insert(events.end(), stepCauses_.begin(), stepCauses_.end());
        break;
    case ConditionKind::count:
    case ConditionKind::all:
    case ConditionKind::any:
        for (ConditionState const& child : children_) {
            if (child.met() == truth) {
                child.collectCauses(world, truth, events);
            }
        }
        break;
    }
    std::erase_if(events, [](EventId event) { return !event; });
}

void ConditionState::collectObjects(std::vector<ObjectId>& objects) const {
    objects.insert(objects.end(), subjects_.begin(), subjects_.end());
    objects.insert(objects.end(), objects_.begin(), objects_.end());
    for (ConditionState const& child : children_) {
        child.collectObjects(objects);
    }
}

} // namespace trembler
