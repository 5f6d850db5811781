#include "runtime/level/build/object_rules.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

namespace trembler {
namespace {

std::optional<std::string> faultOf(ObjectId id, std::span<ObjectFault const> ascending) {
    auto const found =
        std::lower_bound(ascending.begin(), ascending.end(), id,
                         [](ObjectFault const& fault, ObjectId wanted) { return fault.object < wanted; });
    return found != ascending.end() && found->object == id ? std::optional(found->text) : std::nullopt;
}

} // namespace

ObjectRules::ObjectRules(Registry const& registry, Store const& store) : registry_(registry), store_(store) {
    std::span<ObjectRule const> const rules = registry.rules();
    atOnce_.resize(rules.size());
    for (std::size_t i = 0; i < rules.size(); ++i) {
        if (rules[i].checkAll != nullptr && store.findColumn(*rules[i].property) != nullptr) {
            atOnce_[i] = rules[i].checkAll(store);
        }
    }
}

std::vector<BrokenRule> ObjectRules::brokenBy(ObjectId object) const {
    std::vector<BrokenRule> broken;
    std::span<ObjectRule const> const rules = registry_.rules();
    for (std::size_t i = 0; i < rules.size(); ++i) {
        PropertyInfo const& property = *rules[i].property;
        ColumnBase const* const column = store_.findColumn(property);
        if (column == nullptr || !column->has(object)) {
            continue;
        }
        std::optional<std::string> fault =
            rules[i].checkAll != nullptr ? faultOf(object, atOnce_[i]) : rules[i].check(store_, object);
        if (fault) {
            broken.push_back({&property, std::move(*fault)});
        }
    }
    return broken;
}

} // namespace trembler
