// How much the objects of a level hold in their properties.
#pragma once

#include "runtime/level/property/property_set.hpp"

#include <cstddef>

namespace trembler {

/// Bytes of the texts and lists in the properties of all objects of a world when it is built. Every object
/// has its own copy of what its part states, so a few megabytes of parts can become terabytes.
inline constexpr std::size_t mostPropertyBytes = std::size_t{512} << 20U;

/// The bytes that texts and lists in a value take besides the value itself, about; the same on every machine.
[[nodiscard]] std::size_t heldBytes(PropertyValue& value);

/// What is left of a number of bytes. Not thread-safe.
class PropertyAllowance {
public:
    explicit PropertyAllowance(std::size_t most = mostPropertyBytes) : most_(most) {}

    /// Takes the bytes of one more object; returns false if there are too few, also for all objects after it.
    [[nodiscard]] bool take(PropertySet& properties);
    [[nodiscard]] std::size_t most() const { return most_; }

private:
    std::size_t most_;
    std::size_t taken_ = 0;
};

} // namespace trembler
