// The liquids that do not act on an object, in a run that leaves out its dips into them.
#pragma once

#include "runtime/property/description.hpp"

#include <algorithm>
#include <vector>

namespace trembler {

/// No level states it, as it has no physical meaning. It exists only in runs that are compared with the real
/// one, to find out whether the later events depend on a dip.
struct SparedBy {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "Spared by", "spared_by",
        "The liquids that do not act on the object, in a run that leaves out its dips into them.",
        PropertyPlace::hidden};
    std::vector<ObjectId> liquids; ///< ascending

    [[nodiscard]] bool has(ObjectId liquid) const {
        return std::binary_search(liquids.begin(), liquids.end(), liquid);
    }
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "liquids", .unit = "", .meaning = "these liquids"}, self.liquids);
    }
    friend bool operator==(SparedBy const&, SparedBy const&) = default;
};

} // namespace trembler
