// Constructs, binds and destroys components according to the selection.
#include "runtime/world/world.hpp"

#include <map>
#include <utility>

namespace trembler {

// If a component's constructor throws, the world keeps the components that it has, and the next frame begins
// with another selection.
void World::select() {
    selected_ = false;
    SelectionFacts facts{
        .inhabited = {}, .subscribed = {}, .detail = options_.detail, .suits = [this](std::size_t number) {
            Registration const& r = *entries_[number].registration;
            return r.missing.empty() && (r.suits == nullptr || r.suits(store_));
        }};
    for (ColumnBase const* const column : std::as_const(store_).columns()) {
        if (!column->empty()) {
            facts.inhabited.push_back(column->info().text.key);
        }
    }
    for (auto const& [key, count] : wants_->counts()) {
        facts.subscribed.push_back(key);
    }
    std::vector<Choice> choices = selectComponents(graph_, facts);
    bool const onlookers = !facts.subscribed.empty();
    facts.subscribed.clear();
    std::vector<Choice> own = onlookers ? selectComponents(graph_, facts) : choices;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        if (entries_[i].status.period ==
            0) { // left out, see setPeriod(); the calls that it held are withdrawn
            choices[i] = own[i] = {};
        }
    }
    std::vector<std::unique_ptr<Component>> made(entries_.size());
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        if (choices[i].chosen() && !entries_[i].component) {
            made[i] = entries_[i].registration->make();
        }
    }
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        Entry& entry = entries_[i];
        Choice const& choice = choices[i];
        if (std::exchange(entry.own, own[i].chosen()) != entry.own) {
            unbind();
        }
        if (made[i]) {
            unbind();
            install(entry, std::move(made[i]));
        } else if (!choice.chosen() && entry.component) {
            unbind();
            if (!choice.alternative) { // otherwise the alternative continues with the same slots
                for (PropertyInfo const* offer : entry.status.info->offers) {
                    store_.slot(*offer).reset();
                }
            }
            entry.component.reset();
            entry.status.activity = Activity::absent;
        }
        entry.status.choice = choice;
    }
    knownStructure_ = store_.structureVersion();
    if (!bound_) {
        bindAll();
    }
    selected_ = true;
}

void World::install(Entry& entry, std::unique_ptr<Component> component) {
    entry.component = std::move(component);
    entry.component->caller_ = entry.caller;
    entry.lastTick = ticks_;
    entry.status.activity = Activity::asleep; // until its first turn
}

// No turn and no channel refers to a component from then on, so that any of them may be destroyed.
void World::unbind() {
    if (!bound_) {
        return;
    }
    bound_ = false;
    channels_.clearSources();
    for (std::vector<Turn>& turns : turns_) {
        for (Turn& turn : turns) {
            wake(turn);
        }
        turns.clear();
    }
}

namespace {

int countOf(std::map<std::string_view, int> const& counts, std::string_view key) {
    auto const at = counts.find(key);
    return at == counts.end() ? 0 : at->second;
}

} // namespace

void World::bindAll() {
    unbind();
    channels_.clearSources(); // the sources that were bound before an exception
    for (std::vector<Turn>& turns : turns_) {
        turns.clear();
    }
    std::map<std::string_view, int> own; // readers by property: components constructed without subscriptions
    std::map<std::string_view, int> others; // readers by property: all other components
    for (Entry& entry : entries_) {
        if (!entry.component) {
            continue;
        }
        entry.component->bind(store_, channels_);
        if (!runsInside(entry)) { // an interaction inside a derived property set has its turn with it
            turns_[static_cast<std::size_t>(entry.status.info->kind)].push_back(
                {entry.component.get(), entry.index});
        }
        for (PropertyInfo const* read : entry.status.info->reads) {
            ++(entry.own ? own : others)[read->text.key];
        }
    }
    for (auto const& [key, count] : wants_->counts()) {
        others[key] += count;
    }
    news_.clear();
    for (SlotBase* slot : store_.slots()) {
        if (slot->reportsNews()) {
            news_.push_back(slot);
        }
        std::string_view const key = slot->info().text.key;
        slot->setReaders(countOf(own, key), countOf(others, key));
    }
    bound_ = true;
}

} // namespace trembler
