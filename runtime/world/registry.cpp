#include "runtime/world/registry.hpp"

#include "runtime/schedule/schedule.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace trembler {
namespace {

std::set<std::string_view> keys(std::vector<PropertyInfo const*> const& list) {
    std::set<std::string_view> all;
    for (PropertyInfo const* info : list) {
        all.insert(info->text.key);
    }
    return all;
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
    std::set<std::string_view> const offered = keys(dps->offers);
    for (PropertyInfo const* read : interaction->reads) {
        if (read->kind == PropertyKind::derived && !offered.contains(read->text.key)) {
            throw RuleBroken(fmt::format("{} must not run inside the {}: it also reads {}, which that one does not "
                                         "derive (5.7.3)",
                                         title(*interaction), title(*dps), read->text.name));
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
    return a.kind == ComponentKind::dps && keys(a.offers) == keys(b.offers);
}

void Registry::add(Registration const& made) {
    components_.push_back(made);
    for (auto const* list : {&made.info->reads, &made.info->writes, &made.info->neededAll, &made.info->neededAny}) {
        for (PropertyInfo const* info : *list) {
            if (info->kind == PropertyKind::object) {
                know(*info);
            }
        }
    }
}

void Registry::know(PropertyInfo const& info) {
    if (objectProperty(info.text.key) == nullptr) {
        properties_.push_back(&info);
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

void Registry::check() const {
    for (std::size_t i = 0; i < components_.size(); ++i) {
        for (std::size_t j = i + 1; j < components_.size(); ++j) {
            ComponentInfo const& a = *components_[i].info;
            ComponentInfo const& b = *components_[j].info;
            if (title(a) == title(b)) {
                throw RuleBroken(fmt::format("two components are called {}", title(a)));
            }
            if (areAlternatives(a, b)) {
                continue;
            }
            if (a.kind == ComponentKind::resolver && b.kind == ComponentKind::resolver) {
                refuseDoubleWriters(a, b, handOvers_);
            }
            for (PropertyInfo const* offer : a.offers) {
                if (keys(b.offers).contains(offer->text.key)) {
                    throw RuleBroken(fmt::format("the {} and the {} both offer {}, but not the same set of "
                                                 "properties, so neither can stand in for the other",
                                                 title(a), title(b), offer->text.name));
                }
            }
        }
    }
    for (Shortcut const& shortcut : shortcuts_) {
        checkShortcut(*this, shortcut);
    }
}

} // namespace trembler
