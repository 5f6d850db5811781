#include "runtime/world/registry.hpp"

#include "runtime/schedule/schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

namespace trembler {
namespace {

std::set<std::string_view> keys(std::vector<PropertyInfo const*> const& list) {
    std::set<std::string_view> all;
    for (PropertyInfo const* info : list) {
        all.insert(info->text.key);
    }
    return all;
}

bool hasKey(std::vector<PropertyInfo const*> const& list, std::string_view key) {
    return std::any_of(list.begin(), list.end(),
                       [&](PropertyInfo const* info) { return info->text.key == key; });
}

void checkShortcut(Registry const& registry, Shortcut const& shortcut) {
    ComponentInfo const* interaction = nullptr;
    ComponentInfo const* dps = nullptr;
    for (Registration const& r : registry.components()) {
        if (r.info->type == shortcut.interaction) {
            interaction = r.info;
        }
        if (r.info->type == shortcut.dps) {
            dps = r.info;
        }
    }
    if (interaction == nullptr || dps == nullptr) {
        throw RuleBroken("a shortcut (5.7.3) names a component that is not registered");
    }
    if (interaction->kind != ComponentKind::interaction || dps->kind != ComponentKind::dps) {
        throw RuleBroken(
            fmt::format("{} cannot run inside the {}: a shortcut (5.7.3) puts an interaction into a "
                        "derived property set",
                        title(*interaction), title(*dps)));
    }
    std::set<std::string_view> const offered = keys(dps->offers);
    for (PropertyInfo const* read : interaction->reads) {
        if (read->kind == PropertyKind::derived && !offered.contains(read->text.key)) {
            throw RuleBroken(
                fmt::format("{} must not run inside the {}: it also reads {}, which that one does not "
                            "derive (5.7.3)",
                            title(*interaction), title(*dps), read->text.name));
        }
    }
}

// An interaction has one turn in each part of a frame: it may run inside several derived property sets only
// if a world never has more than one of them.
void checkShortcutsOfOne(Registry const& registry, Shortcut const& a, Shortcut const& b) {
    if (a.interaction != b.interaction) {
        return;
    }
    auto const infoOf = [&](std::type_index type) {
        return std::find_if(registry.components().begin(), registry.components().end(),
                            [&](Registration const& r) { return r.info->type == type; })
            ->info;
    };
    if (a.dps == b.dps || !areAlternatives(*infoOf(a.dps), *infoOf(b.dps))) {
        throw RuleBroken(
            fmt::format("{} has shortcuts in the {} and in the {}, which may both be present (5.7.3)",
                        title(*infoOf(a.interaction)), title(*infoOf(a.dps)), title(*infoOf(b.dps))));
    }
}

// Files, columns and slots identify a property by its key, so keys must be unique.
void checkKeys(std::span<PropertyInfo const* const> properties) {
    std::map<std::string_view, PropertyInfo const*> known;
    for (PropertyInfo const* info : properties) {
        auto const [at, isNew] = known.emplace(info->text.key, info);
        if (!isNew && at->second->type != info->type) {
            throw RuleBroken(fmt::format("the properties {} and {} share the key '{}'", at->second->text.name,
                                         info->text.name, info->text.key));
        }
    }
}

// A level names the kind of a connection, not its effect, so a kind must belong to one effect.
void checkConnectors(std::span<Connector const> connectors) {
    std::map<std::string_view, std::string_view> owners;
    for (Connector const& connector : connectors) {
        auto const [at, isNew] = owners.emplace(connector.kind, connector.effect);
        if (!isNew) {
            throw RuleBroken(
                fmt::format("the effects '{}' and '{}' both own the connections of the kind '{}'", at->second,
                            connector.effect, connector.kind));
        }
    }
}

} // namespace

bool areAlternatives(ComponentInfo const& a, ComponentInfo const& b) {
    if (a.kind != b.kind) {
        return false;
    }
    if (a.kind == ComponentKind::resolver) {
        return a.role == b.role;
    }
    // Most are told apart by their first offer; every pair of components is compared.
    return a.kind == ComponentKind::dps &&
           (a.offers.empty() || hasKey(b.offers, a.offers.front()->text.key)) &&
           keys(a.offers) == keys(b.offers);
}

void Registry::add(Registration const& made) {
    components_.push_back(made);
    for (auto const* list :
         {&made.info->reads, &made.info->writes, &made.info->neededAll, &made.info->neededAny}) {
        for (PropertyInfo const* info : *list) {
            if (info->kind == PropertyKind::object) {
                know(*info);
            }
        }
    }
}

void Registry::add(CompletionInfo const& info) {
    completions_.push_back(&info);
    for (auto const* list : {&info.reads, &info.adds, &info.neededAll, &info.neededAny}) {
        for (PropertyInfo const* property : *list) {
            know(*property);
        }
    }
}

void Registry::know(PropertyInfo const& info) {
    PropertyInfo const* const known = objectProperty(info.text.key);
    if (known == nullptr || known->type != info.type) { // two properties of one key are refused by check()
        properties_.push_back(&info);
    }
}

void Registry::makeKnown(Registry const& other) {
    for (PropertyInfo const* info : other.properties_) {
        know(*info);
    }
    for (Connector connector : other.connectors_) {
        connector.lay = [](Store& /*store*/, ObjectId /*a*/, ObjectId /*b*/) {};
        connectors_.push_back(connector);
    }
}

std::vector<PropertyInfo const*> Registry::objectProperties() const {
    std::vector<PropertyInfo const*> sorted = properties_;
    std::sort(sorted.begin(), sorted.end(),
              [](PropertyInfo const* a, PropertyInfo const* b) { return a->text.key < b->text.key; });
    return sorted;
}

PropertyInfo const* Registry::objectProperty(std::string_view key) const {
    auto const at = std::find_if(properties_.begin(), properties_.end(),
                                 [&](PropertyInfo const* info) { return info->text.key == key; });
    return at == properties_.end() ? nullptr : *at;
}

std::vector<std::string> Registry::connectionKinds() const {
    std::vector<std::string> kinds;
    for (Connector const& connector : connectors_) {
        kinds.emplace_back(connector.kind);
    }
    std::sort(kinds.begin(), kinds.end());
    return kinds;
}

std::size_t Registry::registrations() const {
    return components_.size() + properties_.size() + shortcuts_.size() + completions_.size() +
           connectors_.size();
}

void Registry::check() const {
    std::size_t const all = registrations();
    if (checked_.value.load(std::memory_order_relaxed) != all) {
        checkAll();
        checked_.value.store(all, std::memory_order_relaxed);
    }
}

void Registry::checkAll() const {
    checkConnectors(connectors_);
    std::vector<PropertyInfo const*> slots;
    for (Registration const& r : components_) {
        slots.insert(slots.end(), r.info->offers.begin(), r.info->offers.end());
        std::copy_if(r.info->reads.begin(), r.info->reads.end(), std::back_inserter(slots),
                     [](PropertyInfo const* info) { return info->kind != PropertyKind::object; });
    }
    checkKeys(properties_);
    checkKeys(slots);
    for (std::size_t i = 0; i < components_.size(); ++i) {
        for (std::size_t j = i + 1; j < components_.size(); ++j) {
            ComponentInfo const& a = *components_[i].info;
            ComponentInfo const& b = *components_[j].info;
            if (a.kind == b.kind && a.text.name == b.text.name) { // then their titles are the same, too
                throw RuleBroken(fmt::format("two components are called {}", title(a)));
            }
            if (areAlternatives(a, b)) {
                if (keys(a.offers) !=
                    keys(b.offers)) { // possible for resolvers, which are alternatives by role
                    throw RuleBroken(
                        fmt::format("the {} and the {} are both the {} resolver, but do not offer the "
                                    "same properties, so neither can replace the other",
                                    title(a), title(b), a.roleName));
                }
                continue;
            }
            if (a.kind == ComponentKind::resolver && b.kind == ComponentKind::resolver) {
                refuseDoubleWriters(a, b);
            }
            for (PropertyInfo const* offer : a.offers) {
                if (hasKey(b.offers, offer->text.key)) {
                    throw RuleBroken(fmt::format("the {} and the {} both offer {}, but not the same set of "
                                                 "properties, so neither can replace the other",
                                                 title(a), title(b), offer->text.name));
                }
            }
        }
    }
    (void)completionOrder(completions_);
    for (Shortcut const& shortcut : shortcuts_) {
        checkShortcut(*this, shortcut);
    }
    for (std::size_t i = 0; i < shortcuts_.size(); ++i) {
        for (std::size_t j = i + 1; j < shortcuts_.size(); ++j) {
            checkShortcutsOfOne(*this, shortcuts_[i], shortcuts_[j]);
        }
    }
}

} // namespace trembler
