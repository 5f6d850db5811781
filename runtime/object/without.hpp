// The properties that an object is stated not to have.
#pragma once

#include "runtime/property/description.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace trembler {

/// The keys of the properties that a file removes from an object ("conductor": false). Completions do not add
/// these, as the completion of a material otherwise adds conduction.
struct Without {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "Without", "without", "The properties that the object is stated not to have.", PropertyPlace::hidden};
    std::vector<std::string> keys; ///< ascending

    template <class P>
    [[nodiscard]] bool has() const {
        return std::binary_search(keys.begin(), keys.end(), P::text.key);
    }
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "keys", .unit = "", .meaning = "keys of these properties"}, self.keys);
    }
    friend bool operator==(Without const&, Without const&) = default;
};

/// Whether an object that may have a Without is stated not to have P.
template <class P>
[[nodiscard]] bool isWithout(Without const* without) {
    return without != nullptr && without->has<P>();
}

} // namespace trembler
