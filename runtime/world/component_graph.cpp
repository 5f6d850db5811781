#include "runtime/world/component_graph.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <string_view>
#include <typeindex>
#include <utility>

namespace trembler {
namespace {

/// Properties in order of their keys, each once. Columns and slots identify a property by its key, too.
class PropertyNumbers {
public:
    void add(PropertyInfo const* info) { byKey_.emplace(info->text.key, info); }
    /// The properties, by number. To be called after the last add().
    [[nodiscard]] std::vector<PropertyInfo const*> list() const {
        std::vector<PropertyInfo const*> all;
        all.reserve(byKey_.size());
        for (auto const& [key, info] : byKey_) {
            all.push_back(info);
        }
        return all;
    }

private:
    std::map<std::string_view, PropertyInfo const*> byKey_;
};

std::size_t numberIn(std::vector<PropertyInfo const*> const& sorted, PropertyInfo const& info) {
    auto const at = std::lower_bound(
        sorted.begin(), sorted.end(), info.text.key,
        [](PropertyInfo const* property, std::string_view key) { return property->text.key < key; });
    return static_cast<std::size_t>(at - sorted.begin());
}

ComponentGraph::Numbers numbersIn(std::vector<PropertyInfo const*> const& sorted,
                                  std::vector<PropertyInfo const*> const& infos) {
    ComponentGraph::Numbers numbers;
    numbers.reserve(infos.size());
    for (PropertyInfo const* info : infos) {
        numbers.push_back(numberIn(sorted, *info));
    }
    return numbers;
}

std::vector<PropertyInfo const*> withoutObjectProperties(std::vector<PropertyInfo const*> const& infos) {
    std::vector<PropertyInfo const*> rest;
    std::copy_if(infos.begin(), infos.end(), std::back_inserter(rest),
                 [](PropertyInfo const* info) { return info->kind != PropertyKind::object; });
    return rest;
}

/// Puts alternatives into groups: resolvers by their role, derived property sets by what they offer.
class Grouping {
public:
    [[nodiscard]] std::size_t groupOf(ComponentInfo const& info, ComponentGraph::Numbers offers) {
        if (info.kind == ComponentKind::resolver) {
            return numbered(byRole_.try_emplace(info.role, count_));
        }
        if (info.kind == ComponentKind::dps) {
            std::sort(offers.begin(), offers.end());
            offers.erase(std::unique(offers.begin(), offers.end()), offers.end());
            return numbered(byOffers_.try_emplace(std::move(offers), count_));
        }
        return count_++;
    }
    [[nodiscard]] std::optional<std::size_t> resolversOf(ComponentInfo const& interaction) const {
        auto const at = byRole_.find(interaction.role);
        return at == byRole_.end() ? std::nullopt : std::optional(at->second);
    }
    [[nodiscard]] std::size_t count() const { return count_; }

private:
    template <class Made>
    std::size_t numbered(Made const& made) {
        count_ += made.second ? 1 : 0;
        return made.first->second;
    }

    std::map<std::optional<std::type_index>, std::size_t> byRole_;
    std::map<ComponentGraph::Numbers, std::size_t> byOffers_;
    std::size_t count_ = 0;
};

} // namespace

ComponentGraph::ComponentGraph(std::span<ComponentInfo const* const> infos) {
    PropertyNumbers needed;
    PropertyNumbers slots;
    for (ComponentInfo const* info : infos) {
        for (auto const* list : {&info->neededAll, &info->neededAny}) {
            std::for_each(list->begin(), list->end(), [&](auto const* property) { needed.add(property); });
        }
        for (auto const& list : {withoutObjectProperties(info->reads), info->offers}) {
            std::for_each(list.begin(), list.end(), [&](auto const* property) { slots.add(property); });
        }
    }
    objectProperties = needed.list();
    std::vector<PropertyInfo const*> const slotProperties = slots.list();
    for (PropertyInfo const* property : slotProperties) {
        offered.push_back({.info = property, .readers = {}, .providers = {}});
    }
    Grouping grouping;
    components.reserve(infos.size());
    for (ComponentInfo const* info : infos) {
        Component made{.info = info,
                       .neededAll = numbersIn(objectProperties, info->neededAll),
                       .neededAny = numbersIn(objectProperties, info->neededAny),
                       .reads = numbersIn(slotProperties, withoutObjectProperties(info->reads)),
                       .offers = numbersIn(slotProperties, info->offers)};
        made.group = grouping.groupOf(*info, made.offers);
        components.push_back(std::move(made));
    }
    groups.resize(grouping.count());
    for (std::size_t number = 0; number < components.size(); ++number) {
        Component& component = components[number];
        groups[component.group].members.push_back(number);
        for (std::size_t const property : component.reads) {
            offered[property].readers.push_back(number);
        }
        for (std::size_t const property : component.offers) {
            offered[property].providers.push_back(number);
        }
        if (component.info->kind == ComponentKind::interaction) {
            component.resolvers = grouping.resolversOf(*component.info);
            if (component.resolvers) {
                groups[*component.resolvers].callers.push_back(number);
            }
        }
    }
}

} // namespace trembler
