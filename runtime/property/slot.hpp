// Where a resolver property or a derived property lives. The world owns it, not the component that fills it,
// so a component can be swapped for another that offers the same properties and its readers notice nothing.
#pragma once

#include "runtime/property/property_info.hpp"

#include <cstdint>

namespace trembler {

class SlotBase {
public:
    explicit SlotBase(PropertyInfo const& info) : info_(info) {}
    virtual ~SlotBase() = default;
    SlotBase(SlotBase const&) = delete;
    SlotBase& operator=(SlotBase const&) = delete;

    [[nodiscard]] PropertyInfo const& info() const { return info_; }
    [[nodiscard]] std::uint64_t version() const { return version_; }
    void touch() { ++version_; }
    /// How many constructed components read it. A provider need not compute what nobody reads.
    [[nodiscard]] int readers() const { return readers_; }
    void setReaders(int count) { readers_ = count; }
    /// Back to the initial value: nobody provides the property any more.
    virtual void reset() = 0;

private:
    PropertyInfo const& info_;
    std::uint64_t version_ = 1;
    int readers_ = 0;
};

template <Property P>
class Slot final : public SlotBase {
public:
    Slot() : SlotBase(propertyInfo<P>()) {}
    [[nodiscard]] P& value() { return value_; }
    [[nodiscard]] P const& value() const { return value_; }
    void reset() override {
        value_ = P{};
        touch();
    }

private:
    P value_;
};

} // namespace trembler
