#include "insight/timeline/marks.hpp"

#include "audio/effect/properties/sounds.hpp"
#include "physics/buoyancy/properties/results.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "physics/dynamics/properties/motion_causes.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/ratings.hpp"
#include "physics/magnetism/properties.hpp"
#include "runtime/input/input_resolver.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::insight {
namespace {

constexpr double hearingThreshold = 20e-6; // Pa, of 0 dB

} // namespace

void Marks::clear() {
    marks_.clear();
    latest_.clear();
    blown_.clear();
    earlier_.reset();
}

void Marks::forgetAfter(std::uint64_t frame) {
    std::erase_if(marks_, [frame](Mark const& mark) { return mark.frame > frame; });
    std::erase_if(latest_, [frame](auto const& each) { return each.second > frame; });
    blown_.clear();
    earlier_.reset();
}

void Marks::look(World const& world, GoalJudge const& judge) {
    if (!marks_.empty() && world.frame() <= marks_.back().frame) {
        remember(world);
        return; // it was seen before the run was begun again
    }
    lookAtContacts(world);
    lookAtElectricity(world);
    lookAtSounds(world);
    lookAtBreaks(world);
    if (earlier_) {
        lookAtHits(world);
        lookAtLiquids(world);
        lookAtMagnets(world);
    }
    remember(world);
    if (auto const* const commands = world.find<PlayerCommands>()) {
        for (PlayerCommands::Cut const& cut : commands->cuts) {
            add(world, MarkKind::cut, {cut.a, cut.b}, cut.event);
        }
        for (PlayerCommands::Removal const& removal : commands->removals) {
            add(world, MarkKind::cut, {removal.object}, removal.event);
        }
    }
    for (std::size_t i = 0; i < judge.status().size(); ++i) {
        GoalStatus const& goal = judge.status()[i];
        if (goal.frame == world.frame()) {
            add(world, MarkKind::goal, judge.objects(i), {}, goal.id);
        }
    }
}

void Marks::add(World const& world, MarkKind kind, std::vector<ObjectId> const& objects, EventId event,
                std::string goal) {
    if (marks_.size() >= most_ || latest_.size() >= 10 * most_) {
        return;
    }
    Mark mark{world.frame(), kind, {}, std::move(goal), event};
    for (ObjectId const object : objects) {
        mark.objects.push_back(world.store().nameOf(object));
    }
    Key key{kind, mark.objects};
    key.second.push_back(mark.goal);
    auto const [at, isFirst] = latest_.try_emplace(std::move(key), mark.frame);
    bool const isNews = isFirst || mark.frame > at->second + quiet;
    at->second = mark.frame;
    if (isNews) {
        marks_.push_back(std::move(mark));
    }
}

void Marks::lookAtContacts(World const& world) {
    auto const* const contacts = world.find<Contacts>();
    auto const* const conductors = world.store().findColumn<Conductor>();
    if (contacts == nullptr || conductors == nullptr || conductors->empty()) {
        return;
    }
    auto const note = [&](std::vector<TouchingPair> const& pairs, MarkKind kind) {
        for (TouchingPair const& pair : pairs) {
            if (conductors->has(pair.a) && conductors->has(pair.b)) {
                add(world, kind, {pair.a, pair.b}, pair.event);
            }
        }
    };
    note(contacts->begun, MarkKind::contact);
    note(contacts->brief, MarkKind::contact);
    note(contacts->ended, MarkKind::parted);
}

void Marks::lookAtElectricity(World const& world) {
    auto const* const state = world.find<ElectricalState>();
    if (state == nullptr || state->frame != world.frame()) {
        return; // its lists are of an earlier frame
    }
    auto const shows = [&](ObjectId object) {
        return world.find<ElectricalDevice>(object) != nullptr ||
               world.find<Electromagnet>(object) != nullptr;
    };
    for (ObjectId const object : state->switchedOn) {
        if (shows(object)) {
            add(world, MarkKind::on, {object}, state->eventOf(object));
        }
    }
    for (ObjectId const object : state->switchedOff) {
        if (shows(object)) {
            add(world, MarkKind::off, {object}, state->eventOf(object));
        }
    }
}

void Marks::lookAtSounds(World const& world) {
    auto const* const sounds = world.find<Sounds>();
    if (sounds == nullptr || sounds->frame != world.frame()) {
        return;
    }
    double const least = std::pow(10, leastLevel / 10) * hearingThreshold * hearingThreshold; // Pa²
    for (Sounds::Impact const& impact : sounds->impacts) {
        if (impact.meanSquare >= least) {
            add(world, MarkKind::sound, {impact.object}, {});
        }
    }
    for (Sounds::Recording const& recording : sounds->recordings) {
        if (recording.elapsed <= frameDuration) {
            add(world, MarkKind::sound, {recording.object}, recording.event);
        }
    }
}

void Marks::lookAtBreaks(World const& world) {
    if (auto const* const overloaded = world.find<OverloadedJoints>()) {
        for (OverloadedJoints::Entry const& entry : overloaded->entries) {
            add(world, MarkKind::broken, {entry.joint}, entry.event);
        }
    }
    auto const* const fuses = world.store().findColumn<Fuse>();
    for (std::size_t row = 0; fuses != nullptr && row < fuses->size(); ++row) {
        bool const blown = fuses->values()[row].blown;
        ObjectId const owner = fuses->owners()[row];
        auto const [at, isFirst] = blown_.try_emplace(world.store().nameOf(owner), blown);
        if (blown && !at->second && !isFirst) {
            add(world, MarkKind::broken, {owner}, {});
        }
        at->second = blown;
    }
}

void Marks::Earlier::copyVelocities(Store const& store) {
    auto const* const column = store.findColumn<Velocity>();
    if (column == nullptr) {
        movers.clear();
        velocities.clear();
    } else { // two copies of adjacent memory
        movers.assign(column->owners().begin(), column->owners().end());
        velocities.assign(column->values().begin(), column->values().end());
    }
}

Vec2 Marks::Earlier::velocityOf(ObjectId object) const {
    auto const at = std::lower_bound(movers.begin(), movers.end(), object);
    return at == movers.end() || *at != object
               ? Vec2{}
               : velocities[static_cast<std::size_t>(at - movers.begin())].value;
}

void Marks::remember(World const& world) {
    if (!earlier_) {
        earlier_.emplace();
    }
    Earlier& now = *earlier_;
    now.copyVelocities(world.store());
    now.dips.clear();
    now.magnets.clear();
    if (auto const* const immersions = world.find<Immersions>()) {
        for (Immersions::Entry const& entry : immersions->entries) {
            if (entry.liquid.valid()) { // not the air
                now.dips.emplace(entry.object, entry.liquid);
            }
        }
    }
    auto const* const magnets = world.store().findColumn<Magnet>();
    for (std::size_t row = 0; magnets != nullptr && row < magnets->size(); ++row) {
        now.magnets.emplace(magnets->owners()[row], magnets->values()[row].on);
    }
}

void Marks::lookAtHits(World const& world) {
    auto const* const contacts = world.find<Contacts>();
    if (contacts == nullptr) {
        return;
    }
    auto const conducts = [&](ObjectId object) { return world.find<Conductor>(object) != nullptr; };
    for (auto const* const pairs : {&contacts->begun, &contacts->brief}) {
        for (TouchingPair const& pair : *pairs) {
            bool const isFast =
                length(earlier_->velocityOf(pair.a) - earlier_->velocityOf(pair.b)) >= leastSpeed;
            if (!isFast || (conducts(pair.a) && conducts(pair.b))) {
                continue;
            }
            std::string const a = world.store().nameOf(pair.a);
            std::string const b = world.store().nameOf(pair.b);
            if (!latest_.contains({MarkKind::hit, {a, b, ""}})) {
                add(world, MarkKind::hit, {pair.a, pair.b}, pair.event);
            }
        }
    }
}

void Marks::lookAtLiquids(World const& world) {
    auto const* const immersions = world.find<Immersions>();
    if (immersions == nullptr) {
        return;
    }
    std::set<std::pair<ObjectId, ObjectId>> left = earlier_->dips;
    for (Immersions::Entry const& entry : immersions->entries) {
        if (entry.liquid.valid() && left.erase({entry.object, entry.liquid}) == 0) {
            add(world, MarkKind::dips, {entry.object, entry.liquid}, entry.event);
        }
    }
    for (auto const& [object, liquid] : left) {
        if (world.store().alive(object) && world.store().alive(liquid)) {
            add(world, MarkKind::leaves, {object, liquid}, {});
        }
    }
}

void Marks::lookAtMagnets(World const& world) {
    auto const* const magnets = world.store().findColumn<Magnet>();
    for (std::size_t row = 0; magnets != nullptr && row < magnets->size(); ++row) {
        ObjectId const owner = magnets->owners()[row];
        bool const on = magnets->values()[row].on;
        auto const before = earlier_->magnets.find(owner);
        if (before != earlier_->magnets.end() && before->second != on) {
            add(world, on ? MarkKind::magnetOn : MarkKind::magnetOff, {owner}, {});
        }
    }
}

Mark const* Marks::after(std::uint64_t frame) const {
    auto const at = std::upper_bound(marks_.begin(), marks_.end(), frame,
                                     [](std::uint64_t f, Mark const& mark) { return f < mark.frame; });
    return at == marks_.end() ? nullptr : &*at;
}

Mark const* Marks::before(std::uint64_t frame) const {
    auto const at = std::lower_bound(marks_.begin(), marks_.end(), frame,
                                     [](Mark const& mark, std::uint64_t f) { return mark.frame < f; });
    return at == marks_.begin() ? nullptr : &*(at - 1);
}

} // namespace trembler::insight
