// How the properties of a world become words, and words the properties of another world.
#pragma once

#include "insight/timeline/words.hpp"
#include "runtime/world/store.hpp"

#include <span>

namespace trembler::insight {

/// A resolver or derived property that pictures, panels and probes read, with all its members.
struct RecordedSlot {
    PropertyInfo const* info = nullptr;
    /// Of the whole frame. Does nothing if the store has no such slot.
    void (*write)(Store const& store, WordWriter& out) = nullptr;
    void (*read)(Store& store, WordReader& in) = nullptr;
};

/// All recorded properties, in order of their keys. Properties without a meaning outside the component that
/// writes them, such as journals and choices of solvers, are left out.
[[nodiscard]] std::span<RecordedSlot const> recordedSlots();

/// Writes a column: its owners and the value of each. Of properties that resolvers write all members, of
/// others the fields that they describe, which is all that a level states.
void writeColumn(ColumnBase const& column, WordWriter& out);
/// Gives the objects in the words these values, and takes the property from all others. The objects must
/// exist.
void readColumn(ColumnBase& column, WordReader& in);

} // namespace trembler::insight
