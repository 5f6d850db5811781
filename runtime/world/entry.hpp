// One object's entry of a property, in a store in which no object may have that property.
#pragma once

#include "runtime/world/store.hpp"

namespace trembler {

/// nullptr if the object is not valid or does not have it. Valid until the column changes.
template <class P>
[[nodiscard]] P const* entryOf(Store const& store, ObjectId object) {
    auto const* const column = store.findColumn<P>();
    return column == nullptr || !object.valid() ? nullptr : column->find(object);
}

} // namespace trembler
