#include "runtime/world/world.hpp"

#include "runtime/input/input_resolver.hpp"
#include "runtime/schedule/schedule.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

namespace trembler {
World::World(Registry const& registry, WorldOptions options)
    : registry_(registry), options_(std::move(options)), executor_(options_.threads),
      tracer_(options_.trace ? std::make_unique<Tracer>() : nullptr) {
    registry_.check();
    store_.setCompletions(registry_.completions());
    for (ComponentKind const kind :
         {ComponentKind::resolver, ComponentKind::dps, ComponentKind::interaction}) {
        for (Registration const& registration : registry_.components()) {
            if (registration.info->kind == kind) {
                Entry entry;
                entry.registration = &registration;
                entry.status.info = registration.info;
                entry.status.period = registration.period;
                entry.rank = static_cast<std::uint32_t>(entries_.size());
                entries_.push_back(std::move(entry));
            }
        }
    }
    auto const entryOf = [this](std::type_index type) {
        return static_cast<std::size_t>(
            std::find_if(entries_.begin(), entries_.end(),
                         [&](Entry const& e) { return e.status.info->type == type; }) -
            entries_.begin());
    };
    for (Shortcut const& shortcut : registry_.shortcuts()) {
        std::size_t const outer = entryOf(shortcut.dps);
        std::size_t const inner = entryOf(shortcut.interaction);
        entries_[inner].insideOf.push_back(outer);
        entries_[outer].shortcuts.push_back(inner);
    }
    std::map<std::string, std::string> const asked = std::exchange(options_.detail, {});
    for (auto const& [effect, level] : asked) {
        setDetail(effect, level);
    }
    std::map<std::string, int> const periods = std::exchange(options_.periods, {});
    for (auto const& [component, period] : periods) {
        setPeriod(component, period);
    }
}

World::~World() = default;

void World::start() {
    for (std::uint32_t index = 0; index < store_.objects().indexBound(); ++index) {
        if (ObjectId const id = store_.objects().at(index); id.valid()) {
            store_.complete(id);
        }
    }
    select();
}

void World::step() {
    ++frame_;
    notes_ = 0;
    runPhase(ComponentKind::resolver);
    if (tracer_) {
        gatherTrace(); // now, as components, and their events with them, may go in select()
    }
    if (store_.structureVersion() != knownStructure_) {
        select(); // objects came or went: other components may be called for, or none
    }
    runPhase(ComponentKind::dps);
    runPhase(ComponentKind::interaction);
    if (tracer_) {
        gatherTrace();
    }
}

std::uint64_t World::stateHash() const {
    return store_.hash();
}

void World::feed(PlayerInput const& input) {
    if (input_ != nullptr) {
        input_->feed(input);
    }
}

bool World::calledFor(ComponentInfo const& info) const {
    auto const inhabited = [this](PropertyInfo const* p) {
        ColumnBase const* const column = store_.findColumn(*p);
        return column != nullptr && !column->empty();
    };
    return std::all_of(info.neededAll.begin(), info.neededAll.end(), inhabited) &&
           (info.neededAny.empty() || std::any_of(info.neededAny.begin(), info.neededAny.end(), inhabited));
}

bool World::hasProvider(PropertyInfo const& property, std::vector<bool> const& chosen) const {
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        auto const& offers = entries_[i].status.info->offers;
        if (chosen[i] && std::find(offers.begin(), offers.end(), &property) != offers.end()) {
            return true;
        }
    }
    return false;
}

// Among components that serve the same need: the one asked for, else the cheapest that suits the scene.
std::size_t World::pick(std::vector<std::size_t> const& alternatives) const {
    for (std::size_t const i : alternatives) {
        ComponentText const& text = entries_[i].status.info->text;
        auto const asked = options_.detail.find(std::string(text.effect));
        if (asked != options_.detail.end() && asked->second == text.level) {
            return i;
        }
    }
    std::size_t best = alternatives.front();
    bool found = false;
    for (std::size_t const i : alternatives) {
        Registration const& r = *entries_[i].registration;
        bool const suits = r.missing.empty() && (r.suits == nullptr || r.suits(store_));
        if (suits && (!found || r.info->text.cost < entries_[best].status.info->text.cost)) {
            best = i;
            found = true;
        }
    }
    return best;
}

// Whether somebody reads what a component offers: another one that is there, or somebody outside.
bool World::isRead(ComponentInfo const& info, std::vector<bool> const& chosen) const {
    for (PropertyInfo const* offer : info.offers) {
        if (wants_.contains(offer->text.key)) {
            return true;
        }
        for (std::size_t i = 0; i < entries_.size(); ++i) {
            auto const& reads = entries_[i].status.info->reads;
            if (chosen[i] && std::find(reads.begin(), reads.end(), offer) != reads.end()) {
                return true;
            }
        }
    }
    return false;
}

// What is there on demand goes where nobody reads it, and whatever lived on it goes with it; what is left may
// then be unread in turn.
std::vector<bool> World::wanted() const {
    std::vector<bool> unread(entries_.size(), false);
    for (;;) {
        std::vector<bool> chosen = wantedWithout(unread);
        bool more = false;
        for (std::size_t i = 0; i < entries_.size(); ++i) {
            ComponentInfo const& info = *entries_[i].status.info;
            if (chosen[i] && info.onDemand && !isRead(info, chosen)) {
                for (std::size_t j = 0; j < entries_.size(); ++j) {
                    unread[j] = unread[j] || j == i || areAlternatives(info, *entries_[j].status.info);
                }
                more = true;
            }
        }
        if (!more) {
            return chosen;
        }
    }
}

std::vector<bool> World::wantedWithout(std::vector<bool> const& unread) const {
    std::vector<bool> chosen(entries_.size(), false);
    auto const possible = [&](std::size_t entry) {
        ComponentInfo const& info = *entries_[entry].status.info;
        return !unread[entry] && calledFor(info) &&
               std::all_of(info.reads.begin(), info.reads.end(), [&](PropertyInfo const* read) {
                   return read->kind == PropertyKind::object || hasProvider(*read, chosen);
               });
    };
    // Kinds come in the order in which they depend on one another: resolvers, DPS, interactions.
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        ComponentInfo const& info = *entries_[i].status.info;
        if (info.kind == ComponentKind::interaction) {
            bool resolverThere = false;
            for (std::size_t j = 0; j < entries_.size(); ++j) {
                ComponentInfo const& other = *entries_[j].status.info;
                resolverThere = resolverThere || (chosen[j] && other.kind == ComponentKind::resolver &&
                                                  other.role == info.role);
            }
            chosen[i] = possible(i) && resolverThere;
            continue;
        }
        if (!possible(i)) {
            continue;
        }
        std::vector<std::size_t> alternatives;
        for (std::size_t j = 0; j < entries_.size(); ++j) {
            ComponentInfo const& other = *entries_[j].status.info;
            if ((j == i || areAlternatives(info, other)) && possible(j)) {
                alternatives.push_back(j);
            }
        }
        chosen[i] = pick(alternatives) == i;
    }
    return chosen;
}

void World::select() {
    std::vector<bool> const chosen = wanted();
    bool changed = knownStructure_ == 0;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        Entry& entry = entries_[i];
        if (chosen[i] && !entry.component) {
            entry.component = entry.registration->make();
            entry.lastFrame = frame_;
            entry.status.activity = Activity::asleep; // until its first turn
            changed = true;
        } else if (!chosen[i] && entry.component) {
            if (dynamic_cast<InputResolver*>(entry.component.get()) == input_) {
                input_ = nullptr;
            }
            entry.component.reset();
            entry.status.activity = Activity::absent;
            changed = true;
            for (PropertyInfo const* offer : entry.status.info->offers) {
                if (!hasProvider(*offer, chosen)) {
                    store_.slot(*offer).reset();
                }
            }
        }
    }
    if (changed) {
        bindAll();
    }
    knownStructure_ = store_.structureVersion();
}

void World::setWants(PropertyInfo const& property, int change) {
    int& count = wants_[property.text.key];
    count = std::max(0, count + change);
    if (count == 0) {
        wants_.erase(property.text.key);
    }
    if (knownStructure_ != 0) {
        select();
        bindAll(); // even where nobody came or went, the number of readers is another one
    }
}

void World::bindAll() {
    channels_.clearSources();
    std::map<std::string_view, int> readers;
    for (Entry& entry : entries_) {
        if (!entry.component) {
            continue;
        }
        entry.component->bind(store_, channels_);
        for (PropertyInfo const* read : entry.status.info->reads) {
            ++readers[read->text.key];
        }
        if (auto* const input = dynamic_cast<InputResolver*>(entry.component.get())) {
            input_ = input;
        }
    }
    for (auto const& [key, count] : wants_) {
        readers[key] += count;
    }
    for (SlotBase* slot : store_.slots()) {
        auto const at = readers.find(slot->info().text.key);
        slot->setReaders(at == readers.end() ? 0 : at->second);
    }
}

bool World::due(Entry const& entry) const {
    return (frame_ - 1) % static_cast<std::uint64_t>(entry.status.period) == 0;
}

void World::runEntry(Entry& entry) {
    auto const before = std::chrono::steady_clock::now();
    FrameContext const context{.frame = frame_,
                               .duration = frameDuration * static_cast<double>(frame_ - entry.lastFrame),
                               .executor = &executor_,
                               .store = &store_,
                               .tracing = tracer_ != nullptr,
                               .component = entry.rank};
    entry.component->run(context);
    entry.lastFrame = frame_;
    ++entry.status.updates;
    std::chrono::duration<double, std::micro> const took = std::chrono::steady_clock::now() - before;
    entry.status.lastMicroseconds = took.count();
    entry.status.totalMicroseconds += took.count();
}

bool World::runsInside(Entry const& entry) const {
    return std::any_of(entry.insideOf.begin(), entry.insideOf.end(),
                       [this](std::size_t outer) { return entries_[outer].component != nullptr; });
}

// Runs a component, or lets it sleep if there is nothing for it to do.
void World::giveTurn(Entry& entry) {
    if (entry.component->hasWork()) {
        runEntry(entry);
        entry.status.activity = Activity::active;
        return;
    }
    entry.status.activity = Activity::asleep;
    entry.status.lastMicroseconds = 0;
    if (entry.status.info->kind == ComponentKind::resolver) {
        entry.lastFrame = frame_; // it slept through this time, there is none to catch up
    }
}

void World::runPhase(ComponentKind kind) {
    auto const hasTurn = [this](Entry const& entry) { return entry.component && due(entry); };
    std::vector<std::size_t> running;
    std::size_t rows = 0;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        Entry& entry = entries_[i];
        if (entry.status.info->kind != kind || !entry.component || runsInside(entry)) {
            continue; // what runs inside a derived property set has its turns there
        }
        bool runs = false;
        auto const consider = [&](Entry& candidate) {
            if (!hasTurn(candidate)) {
                return;
            }
            if (candidate.component->hasWork()) {
                rows += candidate.component->workload();
                runs = true;
            } else if (kind == ComponentKind::resolver) {
                runs = true; // it may be given work by one that runs before it, so it decides when its turn
                             // comes
            } else {
                giveTurn(candidate);
            }
        };
        consider(entry);
        for (std::size_t const inner : entry.shortcuts) {
            consider(entries_[inner]);
        }
        if (runs) {
            running.push_back(i);
        }
    }
    auto const turn = [&](std::size_t n) {
        Entry& entry = entries_[running[n]];
        if (hasTurn(entry)) {
            giveTurn(entry);
        }
        for (std::size_t const inner : entry.shortcuts) {
            if (hasTurn(entries_[inner])) {
                giveTurn(entries_[inner]);
            }
        }
    };
    if (executor_.threads() == 1 || running.size() <= 1 || rows < options_.rowsWorthThreads) {
        for (std::size_t n = 0; n < running.size(); ++n) {
            turn(n);
        }
        return;
    }
    if (kind == ComponentKind::resolver) {
        std::vector<ComponentInfo const*> infos;
        infos.reserve(running.size());
        for (std::size_t const i : running) {
            infos.push_back(entries_[i].status.info);
        }
        executor_.runGraph(running.size(), deriveEdges(infos), turn);
    } else {
        executor_.forIndices(running.size(), turn);
    }
}

void World::gatherTrace() {
    for (Entry& entry : entries_) {
        if (entry.component) {
            for (EventSink& sink : entry.component->sinks()) {
                tracer_->gather(sink);
            }
        }
    }
}

EventId World::note(std::string_view component, std::string_view event, std::span<ObjectId const> objects,
                    std::span<EventId const> causes) {
    if (!tracer_) {
        return {};
    }
    constexpr std::uint32_t afterAllComponents = 255;
    EventSink sink(&store_, frame_, afterAllComponents, notes_++, Phase::goal, component);
    EventId const id = sink.record(event, objects, causes);
    tracer_->gather(sink);
    return id;
}

void World::setDetail(std::string const& effect, std::string const& level) {
    std::set<std::string_view> effects;
    std::set<std::string_view> levels;
    for (Entry const& entry : entries_) {
        ComponentText const& text = entry.status.info->text;
        if (!text.level.empty()) {
            effects.insert(text.effect);
            if (text.effect == effect) {
                levels.insert(text.level);
            }
            if (text.effect == effect && text.level == level && !entry.registration->missing.empty()) {
                throw std::invalid_argument(
                    fmt::format("{}={} cannot be had: {}", effect, level, entry.registration->missing));
            }
        }
    }
    if (levels.empty()) {
        throw std::invalid_argument(fmt::format("no effect '{}' has detail levels; those that have: {}",
                                                effect, fmt::join(effects, ", ")));
    }
    if (level.empty()) {
        options_.detail.erase(effect);
    } else if (levels.contains(level)) {
        options_.detail[effect] = level;
    } else {
        throw std::invalid_argument(
            fmt::format("{} has no detail level '{}'; it has: {}", effect, level, fmt::join(levels, ", ")));
    }
    if (knownStructure_ != 0) {
        select();
    }
}

void World::setPeriod(std::string const& componentTitle, int period) {
    if (period < 1 || period > 3600) {
        throw std::invalid_argument(
            fmt::format("the period of '{}' is {}; expected 1 to 3600 frames", componentTitle, period));
    }
    std::vector<std::string> titles;
    std::vector<Entry*> named;
    for (Entry& entry : entries_) {
        titles.push_back(title(*entry.status.info));
        if (titles.back() == componentTitle) {
            named.assign(1, &entry); // a full title goes before a bare name
            break;
        }
        if (entry.status.info->text.name == componentTitle) {
            named.push_back(&entry);
        }
    }
    if (named.size() > 1) {
        titles.clear();
        for (Entry const* entry : named) {
            titles.push_back(title(*entry->status.info));
        }
        throw std::invalid_argument(
            fmt::format("'{}' may mean any of these: {}", componentTitle, fmt::join(titles, ", ")));
    }
    if (named.empty()) {
        throw std::invalid_argument(fmt::format("there is no component '{}'; there are: {}", componentTitle,
                                                fmt::join(titles, ", ")));
    }
    named.front()->status.period = period;
    options_.periods[title(*named.front()->status.info)] = period;
}

std::string World::why(std::string_view effect) const {
    for (Entry const& entry : entries_) {
        if (entry.component && entry.registration->why != nullptr &&
            entry.status.info->text.effect == effect) {
            return entry.registration->why(store_);
        }
    }
    return {};
}

std::vector<ComponentStatus> World::status() const {
    std::vector<ComponentStatus> all;
    all.reserve(entries_.size());
    for (Entry const& entry : entries_) {
        all.push_back(entry.status);
    }
    return all;
}

} // namespace trembler
