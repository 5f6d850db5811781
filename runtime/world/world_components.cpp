// Constructs, binds and destroys components according to the selection.
#include "runtime/world/world.hpp"

#include <map>
#include <utility>

namespace trembler {

void World::select() {
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
    std::vector<Choice> const choices = selectComponents(graph_, facts);
    bool const onlookers = !facts.subscribed.empty();
    facts.subscribed.clear();
    std::vector<Choice> const own = onlookers ? selectComponents(graph_, facts) : choices;
    bool changed = knownStructure_ == 0;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        Entry& entry = entries_[i];
        Choice const& choice = choices[i];
        entry.status.choice = choice;
        changed = std::exchange(entry.own, own[i].chosen()) != entry.own || changed;
        if (choice.chosen() && !entry.component) {
            construct(entry);
            changed = true;
        } else if (!choice.chosen() && entry.component) {
            entry.component.reset();
            entry.status.activity = Activity::absent;
            changed = true;
            if (!choice.alternative) { // otherwise the alternative continues with the same slots
                for (PropertyInfo const* offer : entry.status.info->offers) {
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

void World::construct(Entry& entry) {
    entry.component = entry.registration->make();
    entry.component->caller_ = entry.caller;
    entry.lastTick = ticks_;
    entry.status.activity = Activity::asleep; // until its first turn
}

namespace {

int countOf(std::map<std::string_view, int> const& counts, std::string_view key) {
    auto const at = counts.find(key);
    return at == counts.end() ? 0 : at->second;
}

} // namespace

void World::bindAll() {
    channels_.clearSources();
    for (std::vector<Turn>& turns : turns_) {
        for (Turn& turn : turns) {
            wake(turn);
        }
        turns.clear();
    }
    std::map<std::string_view, int> own; // readers by property: components constructed without subscriptions
    std::map<std::string_view, int> others; // and all others
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
}

} // namespace trembler
