#include "runtime/world/world.hpp"

#include "runtime/frame/frame_resolver.hpp"
#include "runtime/schedule/schedule.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

namespace trembler {
namespace {

static_assert(World::ticksPerFrame == mostParts);

/// Sets a flag, and takes it back at the end, however that comes about.
class Raised {
public:
    explicit Raised(bool& flag) : flag_(flag) { flag_ = true; }
    ~Raised() { flag_ = false; }
    Raised(Raised const&) = delete;
    Raised& operator=(Raised const&) = delete;

private:
    bool& flag_;
};

} // namespace

World::World(Registry const& registry, WorldOptions options)
    : registry_(registry), options_(std::move(options)), executor_(options_.threads),
      tracer_(options_.trace ? std::make_unique<Tracer>() : nullptr) {
    registry_.check();
    std::vector<Store::Completion> completions;
    for (CompletionInfo const* completion : completionOrder(registry_.completions())) {
        completions.push_back(completion->run);
    }
    store_.setCompletions(std::move(completions));
    for (ComponentKind const kind :
         {ComponentKind::resolver, ComponentKind::dps, ComponentKind::interaction}) {
        for (Registration const& registration : registry_.components()) {
            if (registration.info->kind == kind) {
                Entry entry;
                entry.registration = &registration;
                entry.status.info = registration.info;
                entry.status.period = registration.period;
                entry.status.longestPeriod = registration.longestPeriod;
                entry.rank = static_cast<std::uint32_t>(entries_.size());
                if (std::find(registration.info->offers.begin(), registration.info->offers.end(),
                              &propertyInfo<FrameParts>()) != registration.info->offers.end()) {
                    divider_ = entries_.size();
                }
                if (kind == ComponentKind::interaction) {
                    entry.caller = callers_.add(registration.info->text.name);
                }
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
    std::vector<ObjectId> objects;
    for (std::uint32_t index = 0; index < store_.objects().indexBound(); ++index) {
        if (ObjectId const id = store_.objects().at(index); id.valid()) {
            objects.push_back(id);
        }
    }
    store_.complete(objects);
    select();
    setUp();
}

// What resolvers must know in their first advance is told to them in frame 0.
void World::setUp() {
    for (Entry& entry : entries_) {
        if (entry.component && entry.status.info->inSetup) {
            runEntry(entry);
        }
    }
    if (tracer_) {
        gatherTrace();
    }
}

void World::step(PartLook const& look) {
    if (knownStructure_ != 0 && wants_->takeChanged()) {
        select();
        bindAll(); // even where nobody came or went, the number of readers is another one
    }
    Raised const raised(underWay_);
    now_ = {now_.frame + 1, 1, 1, now_.step + 1};
    ticks_ = (now_.frame - 1) * ticksPerFrame;
    now_.parts = chooseParts();
    for (SlotBase* const slot : news_) {
        slot->beginFrame();
    }
    for (;;) {
        ticks_ = (now_.frame - 1) * ticksPerFrame + now_.part * (ticksPerFrame / now_.parts);
        runPart();
        if (now_.parts > 1) {
            gatherNews();
        }
        if (look) {
            look(*this);
        }
        if (now_.part == now_.parts) {
            return;
        }
        // Where nobody had anything to do, nothing is going to change in the parts to come, but in the last
        // one, in which those with a period have their turn.
        if (anybodyRan()) {
            ++now_.part;
        } else {
            // Whoever slept in this part sleeps through them too: woken in the last one, it has had a turn in
            // the one before.
            std::uint64_t const skipped =
                (now_.parts - now_.part - 1) * std::uint64_t{ticksPerFrame / now_.parts};
            for (Entry& entry : entries_) {
                entry.lastTick += entry.component && entry.lastTick == ticks_ ? skipped : 0;
            }
            now_.part = now_.parts;
        }
        ++now_.step;
    }
}

// Who says in how many parts a frame is computed has a turn of its own before the first of them, and so sees
// what interactions had told at the end of the frame before.
std::uint32_t World::chooseParts() {
    if (!divider_ || !entries_[*divider_].component) {
        return 1;
    }
    if ((now_.frame - 1) % static_cast<std::uint64_t>(entries_[*divider_].status.period) == 0) {
        giveTurn(entries_[*divider_]);
    }
    int const parts = store_.slot<FrameParts>().value().parts;
    return static_cast<std::uint32_t>(roundedParts(parts));
}

void World::gatherNews() {
    double const share = 1.0 / now_.parts;
    double const begin = frameDuration * (now_.part - 1) * share;
    for (SlotBase* const slot : news_) {
        slot->endPart(begin, share);
    }
}

bool World::anybodyRan() const {
    return std::any_of(entries_.begin(), entries_.end(),
                       [this](Entry const& entry) { return entry.component && entry.ranTick == ticks_; });
}

void World::runPart() {
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

bool World::activation(ComponentInfo const& info) const {
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

// Among components that serve the same need: the one asked for, else the one of least rank that suits the
// scene.
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
        if (suits && (!found || r.info->text.rank < entries_[best].status.info->text.rank)) {
            best = i;
            found = true;
        }
    }
    return best;
}

// Whether somebody reads what a component offers: another one that is there, or somebody outside.
bool World::isRead(ComponentInfo const& info, std::vector<bool> const& chosen, bool byOnlookers) const {
    for (PropertyInfo const* offer : info.offers) {
        if (byOnlookers && wants_->contains(*offer)) {
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
std::vector<bool> World::wanted(bool byOnlookers) const {
    std::vector<bool> unread(entries_.size(), false);
    for (;;) {
        std::vector<bool> chosen = wantedWithout(unread);
        bool more = false;
        for (std::size_t i = 0; i < entries_.size(); ++i) {
            ComponentInfo const& info = *entries_[i].status.info;
            if (chosen[i] && info.onDemand && !isRead(info, chosen, byOnlookers)) {
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
        return !unread[entry] && activation(info) &&
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
    std::vector<bool> const chosen = wanted(true);
    std::vector<bool> const own = wanted(false);
    bool changed = knownStructure_ == 0;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        Entry& entry = entries_[i];
        entry.own = own[i];
        if (chosen[i] && !entry.component) {
            entry.component = entry.registration->make();
            entry.component->caller_ = entry.caller;
            entry.lastTick = ticks_;
            entry.status.activity = Activity::asleep; // until its first turn
            changed = true;
        } else if (!chosen[i] && entry.component) {
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
    }
    for (auto const& [key, count] : wants_->counts()) {
        readers[key] += count;
    }
    news_.clear();
    for (SlotBase* slot : store_.slots()) {
        if (slot->tellsNews()) {
            news_.push_back(slot);
        }
        auto const at = readers.find(slot->info().text.key);
        slot->setReaders(at == readers.end() ? 0 : at->second);
    }
}

bool World::due(Entry const& entry) const {
    if (divider_ && &entry == &entries_[*divider_]) {
        return false; // its turn was before the frame
    }
    auto const period = static_cast<std::uint64_t>(entry.status.period);
    return period == 1 || (now_.part == now_.parts && (now_.frame - 1) % period == 0);
}

void World::runEntry(Entry& entry) {
    auto const before = std::chrono::steady_clock::now();
    FrameContext const context{.when = now_,
                               .duration = secondsIn(ticks_ - entry.lastTick),
                               .executor = &executor_,
                               .store = &store_,
                               .tracing = tracer_ != nullptr,
                               .component = entry.rank};
    entry.component->run(context);
    entry.lastTick = ticks_;
    entry.ranTick = ticks_;
    ++entry.status.updates;
    std::chrono::duration<double, std::micro> const took = std::chrono::steady_clock::now() - before;
    entry.status.lastMicroseconds += took.count();
    entry.status.totalMicroseconds += took.count();
}

bool World::runsInside(Entry const& entry) const {
    return std::any_of(entry.insideOf.begin(), entry.insideOf.end(),
                       [this](std::size_t outer) { return entries_[outer].component != nullptr; });
}

// Runs a component, or lets it sleep if there is nothing for it to do.
void World::giveTurn(Entry& entry) {
    if (now_.part == 1 || entry.status.period > 1) { // its first turn in this frame
        entry.status.activity = Activity::asleep;
        entry.status.lastMicroseconds = 0;
    }
    if (entry.component->hasWork()) {
        runEntry(entry);
        entry.status.activity = Activity::active;
        return;
    }
    entry.lastTick = ticks_; // it slept through this time, there is none to catch up
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
    EventSink sink(&store_, now_, afterAllComponents, notes_++, Phase::goal, component);
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
