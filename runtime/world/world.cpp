#include "runtime/world/world.hpp"

#include "runtime/frame/frame_resolver.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace trembler {

World::World(Registry const& registry, WorldOptions options)
    : registry_(registry), options_(std::move(options)), executor_(options_.threads),
      tracer_(options_.trace ? std::make_unique<Tracer>() : nullptr) {
    registry_.check();
    std::vector<Store::Completion> completions;
    for (CompletionInfo const* completion : completionOrder(registry_.completions())) {
        completions.push_back(completion->run);
    }
    store_.setCompletions(std::move(completions));
    addEntries();
    linkShortcuts();
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

void World::addEntries() {
    for (ComponentKind const kind :
         {ComponentKind::resolver, ComponentKind::dps, ComponentKind::interaction}) {
        for (Registration const& registration : registry_.components()) {
            if (registration.info->kind == kind) {
                Entry entry;
                entry.registration = &registration;
                entry.status.info = registration.info;
                entry.status.period = registration.period;
                entry.status.longestPeriod = registration.longestPeriod;
                entry.index = static_cast<std::uint32_t>(entries_.size());
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
    std::vector<ComponentInfo const*> infos;
    for (Entry const& entry : entries_) {
        infos.push_back(entry.status.info);
    }
    graph_ = ComponentGraph(infos);
}

void World::linkShortcuts() {
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
}

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

// Interactions of the setup are applied in frame 0, so that their resolvers receive these calls in their
// first advance.
void World::setUp() {
    for (Entry& entry : entries_) {
        if (entry.component && entry.status.info->inSetup) {
            runEntry(entry);
        }
    }
    if (tracer_) {
        gatherTrace();
    }
    whole_ = true;
}

// In most parts of a frame nothing happens: looking at all components would take longer than some frames do.
void World::gatherTrace() {
    if (!eventful_.exchange(false, std::memory_order_relaxed)) {
        return;
    }
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

std::string World::why(std::string_view effect) const {
    for (Entry const& entry : entries_) {
        if (entry.status.choice.chosen() && entry.registration->why != nullptr &&
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
