#include "lua/component/scripted_interaction.hpp"

#include "physics/dynamics/properties/contacts.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace trembler::lua {
namespace {

// A property that the host reads for the script; declare() has declared it.
template <ObjectProperty P>
Column<P> const* columnOf(Script const& script, std::vector<Home> const& homes) {
    std::size_t i = 0;
    while (script.reads[i].info->type != typeid(P)) {
        ++i;
    }
    return static_cast<Column<P> const*>(homes[i].column);
}
Slot<Contacts> const* contactsOf(Script const& script, std::vector<Home> const& homes) {
    std::size_t i = 0;
    while (script.reads[i].info->type != typeid(Contacts)) {
        ++i;
    }
    return static_cast<Slot<Contacts> const*>(homes[i].slot);
}

} // namespace

ScriptedInteraction::ScriptedInteraction(std::shared_ptr<Script const> script, std::shared_ptr<ScriptLog> log)
    : Component(*script->info), restless_(script->manifest.restless), script_(std::move(script)),
      log_(std::move(log)), source_(script_->role->open()), kept_(script_->manifest) {}

ScriptedInteraction::~ScriptedInteraction() = default;

void ScriptedInteraction::bind(Store& store, Channels& channels) {
    store_ = &store;
    bindReads(store);
    targetsOf_.clear(); // the new store has other columns
    source_->attach(channels, caller());
    sleep();
}

void ScriptedInteraction::bindReads(Store& store) {
    homes_.clear();
    watches_.resize(script_->reads.size());
    for (DeclaredProperty const& property : script_->reads) {
        Home home;
        if (property.ofObjects()) {
            home.column = &store.column(*property.info);
        } else {
            home.slot = &store.slot(*property.info);
        }
        watches_[homes_.size()].version = home.versionPlace();
        homes_.push_back(home);
    }
}

/// Lets the world skip the component while hasWork() is false. To be called after every change of data on
/// which hasWork() depends.
void ScriptedInteraction::sleep() {
    if (off_ || resting_) {
        waitFor({});
    } else if (first_ || restless_) {
        wake();
    } else {
        waitFor(watches_);
    }
}

bool ScriptedInteraction::hasWork() const {
    if (off_ || resting_) {
        return false;
    }
    if (first_ || restless_) {
        return true;
    }
    return std::any_of(watches_.begin(), watches_.end(), [](Watch const& w) { return w.changed(); });
}

std::size_t ScriptedInteraction::workload() const {
    std::size_t rows = 0;
    for (Home const& home : homes_) {
        rows += home.column == nullptr ? 0 : home.column->size();
    }
    return rows;
}

void ScriptedInteraction::run(FrameContext const& context) {
    openSinks(context, Phase::interaction);
    source_->begin();
    try {
        applyScript(context);
    } catch (...) { // of the host: errors of the script are results
        source_->fail();
        sinks_.clear();
        throw;
    }
    source_->end();
    for (Watch& watch : watches_) {
        watch.seen = *watch.version;
    }
    first_ = false;
    sleep();
}

void ScriptedInteraction::applyScript(FrameContext const& context) {
    bool const same = targetsStand();
    if (!same) {
        findTargets(context);
    }
    std::optional<ScriptError> failed;
    if (targets_.size() > mostPairs && script_->manifest.application == Application::pairs) {
        failed = ScriptError{
            fmt::format("the script is applied to more than {} pairs of objects in a turn", mostPairs),
            {},
            true};
    } else if (!targets_.empty() && !turns_) {
        turns_ = std::make_unique<Turns>(script_);
        failed = turns_->broken();
    }
    if (!failed && !targets_.empty()) {
        kept_.keepOnly([this](ObjectId id) { return store_->alive(id); });
        TurnContext turn{.store = *store_,
                         .homes = homes_,
                         .kept = kept_,
                         .source = *source_,
                         .sink = sinks_.empty() ? nullptr : &sinks_.front(),
                         .duration = context.duration,
                         .sameTargets = same,
                         .sameFrame = frame_ == context.when.frame,
                         .log = [&](std::string const& line) {
                             log_->add({.script = script_->manifest.name,
                                        .frame = context.when.frame,
                                        .error = false,
                                        .text = line,
                                        .traceback = {}});
                         }};
        frame_ = context.when.frame;
        failed = turns_->run(turn, targets_);
    }
    if (failed) {
        switchOff(context, *failed);
    }
}

void ScriptedInteraction::switchOff(FrameContext const& context, ScriptError const& failed) {
    source_->withdraw();
    off_ = true;
    turns_.reset();
    if (!sinks_.empty()) {
        (void)sinks_.front().record("switched off: " + failed.message, {}, {});
    }
    log_->add({.script = script_->manifest.name,
               .frame = context.when.frame,
               .error = true,
               .text = failed.message,
               .traceback = failed.traceback});
}

void ScriptedInteraction::hashState(StateHash& hash) const {
    hash.value(off_ || resting_);
    kept_.hash(hash);
}

// ---- The targets, always in the order of objects.

/// Whether this turn has the targets of the last one: no object was added to or removed from the columns by
/// which targets are found, and no object has changed the parameters that it states.
bool ScriptedInteraction::targetsStand() {
    if (script_->manifest.application != Application::each) {
        return script_->manifest.application == Application::once && !targets_.empty();
    }
    std::vector<std::uint64_t> now;
    for (std::size_t const read : script_->first) {
        now.push_back(homes_[read].column->structureVersion());
    }
    if (script_->manifest.attached) {
        now.push_back(columnOf<Scripts>(*script_, homes_)->version());
        now.push_back(columnOf<Scripts>(*script_, homes_)->structureVersion());
    }
    return std::exchange(targetsOf_, now) == now;
}

void ScriptedInteraction::findTargets(FrameContext const& /*context*/) {
    targets_.clear();
    switch (script_->manifest.application) {
    case Application::once:
        targets_.push_back({});
        return;
    case Application::each:
        findEach();
        return;
    case Application::pairs:
        findPairs();
        return;
    }
}

ScriptUse const* ScriptedInteraction::useOf(ObjectId id) const {
    Scripts const* const scripts = columnOf<Scripts>(*script_, homes_)->find(id);
    if (scripts == nullptr) {
        return nullptr;
    }
    auto const use =
        std::find_if(scripts->uses.begin(), scripts->uses.end(),
                     [this](ScriptUse const& stated) { return stated.script == script_->manifest.name; });
    return use == scripts->uses.end() ? nullptr : &*use;
}

bool ScriptedInteraction::hasAll(ObjectId id, std::vector<std::size_t> const& needed, bool attached) const {
    return std::all_of(needed.begin(), needed.end(),
                       [&](std::size_t read) { return homes_[read].column->has(id); }) &&
           (!attached || useOf(id) != nullptr);
}

std::vector<ObjectId> ScriptedInteraction::havingAll(std::vector<std::size_t> const& needed,
                                                     bool attached) const {
    ColumnBase const* rarest = attached ? columnOf<Scripts>(*script_, homes_) : nullptr;
    for (std::size_t const read : needed) {
        if (rarest == nullptr || homes_[read].column->size() < rarest->size()) {
            rarest = homes_[read].column;
        }
    }
    std::vector<ObjectId> all;
    if (rarest != nullptr) {
        std::copy_if(rarest->owners().begin(), rarest->owners().end(), std::back_inserter(all),
                     [&](ObjectId id) { return hasAll(id, needed, attached); });
    }
    return all;
}

void ScriptedInteraction::findEach() {
    bool const attached = script_->manifest.attached;
    for (ObjectId const id : havingAll(script_->first, attached)) {
        targets_.push_back({.first = id, .second = {}, .use = attached ? useOf(id) : nullptr, .cause = {}});
    }
}

void ScriptedInteraction::findPairs() {
    if (script_->manifest.touching) {
        findTouching();
    } else {
        findNear();
    }
}

void ScriptedInteraction::findTouching() {
    bool const attached = script_->manifest.attached;
    bool const alike = script_->manifest.first == script_->manifest.second && !attached;
    auto const add = [&](ObjectId a, ObjectId b, EventId cause) {
        if (hasAll(a, script_->first, attached) && hasAll(b, script_->second, false)) {
            targets_.push_back(
                {.first = a, .second = b, .use = attached ? useOf(a) : nullptr, .cause = cause});
        }
    };
    for (TouchingPair const& pair : contactsOf(*script_, homes_)->value().current) {
        add(pair.a, pair.b, pair.event);
        if (!alike) {
            add(pair.b, pair.a, pair.event);
        }
    }
    std::sort(targets_.begin(), targets_.end(), [](Target const& x, Target const& y) {
        return std::pair(x.first, x.second) < std::pair(y.first, y.second);
    });
}

double ScriptedInteraction::reachOf(ScriptUse const* use) const {
    Manifest const& manifest = script_->manifest;
    if (manifest.withinParameter.empty()) {
        return manifest.within;
    }
    if (use != nullptr) {
        for (ScriptSetting const& setting : use->settings) {
            if (setting.parameter == manifest.withinParameter) {
                return setting.number;
            }
        }
    }
    return std::get<double>(manifest.parameter(manifest.withinParameter)->initial);
}

// Sorts along x: O(n log n), plus the number of pairs that are near in x.
void ScriptedInteraction::findNear() {
    struct Place {
        double x;
        double y;
        ObjectId id;
    };
    bool const attached = script_->manifest.attached;
    bool const alike = script_->manifest.first == script_->manifest.second && !attached;
    auto const* const positions = columnOf<Position>(*script_, homes_);
    std::vector<Place> places;
    for (ObjectId const id : havingAll(script_->second, false)) {
        if (Position const* const position = positions->find(id)) {
            places.push_back({position->value.x, position->value.y, id});
        }
    }
    std::sort(places.begin(), places.end(),
              [](Place const& a, Place const& b) { return a.x != b.x ? a.x < b.x : a.id < b.id; });
    for (ObjectId const id : havingAll(script_->first, attached)) {
        Position const* const at = positions->find(id);
        if (at == nullptr) {
            continue;
        }
        ScriptUse const* const use = attached ? useOf(id) : nullptr;
        double const reach = reachOf(use);
        std::size_t const begin = targets_.size();
        auto const from = std::lower_bound(places.begin(), places.end(), at->value.x - reach,
                                           [](Place const& place, double x) { return place.x < x; });
        for (auto near = from; near != places.end() && near->x <= at->value.x + reach; ++near) {
            Vec2 const apart{near->x - at->value.x, near->y - at->value.y};
            if (targets_.size() > mostPairs) {
                return;
            }
            if (near->id != id && dot(apart, apart) <= reach * reach && !(alike && near->id < id)) {
                targets_.push_back({.first = id, .second = near->id, .use = use, .cause = {}});
            }
        }
        std::sort(targets_.begin() + static_cast<std::ptrdiff_t>(begin), targets_.end(),
                  [](Target const& x, Target const& y) { return x.second < y.second; });
    }
}

} // namespace trembler::lua
