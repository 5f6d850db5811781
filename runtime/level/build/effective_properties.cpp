#include "runtime/level/build/effective_properties.hpp"

#include <algorithm>

namespace trembler {

PropertySet effectiveProperties(PropertySet const& part, PropertySet const& own) {
    PropertySet all = part;
    for (PropertySet::Entry const& entry : own.entries()) {
        if (entry.value) {
            all.set(entry.value->clone());
        } else {
            all.erase(*entry.info);
        }
    }
    PropertySet present;
    for (PropertySet::Entry const& entry : all.entries()) {
        if (entry.value) {
            present.set(entry.value->clone());
        }
    }
    return present;
}

std::vector<std::string> statedAbsent(PropertySet const& part, PropertySet const& own) {
    std::vector<std::string> keys;
    for (PropertySet::Entry const& entry : part.entries()) {
        if (!entry.value && !own.states(*entry.info)) {
            keys.emplace_back(entry.info->text.key);
        }
    }
    for (PropertySet::Entry const& entry : own.entries()) {
        if (!entry.value) {
            keys.emplace_back(entry.info->text.key);
        }
    }
    std::sort(keys.begin(), keys.end());
    return keys;
}

} // namespace trembler
