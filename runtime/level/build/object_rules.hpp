// Which rules of the registry an object breaks.
#pragma once

#include "runtime/world/registry.hpp"
#include "runtime/world/store.hpp"

#include <string>
#include <vector>

namespace trembler {

struct BrokenRule {
    PropertyInfo const* property; ///< that the rule is about
    std::string fault;            ///< in words
};

/// The rules of a registry (see ObjectRule) for the objects of a store. Rules that check all objects at once
/// do so when this is made; neither registry nor store may change while it lives.
class ObjectRules {
public:
    ObjectRules(Registry const& registry, Store const& store);

    /// In the order in which the rules were registered. Empty for an object that does not exist.
    [[nodiscard]] std::vector<BrokenRule> brokenBy(ObjectId object) const;

private:
    Registry const& registry_;
    Store const& store_;
    std::vector<std::vector<ObjectFault>> atOnce_; ///< by index of the rule; ascending by object
};

} // namespace trembler
