// Readers outside a world: a loudspeaker, an overlay, a recorder.
#pragma once

#include "runtime/property/property_info.hpp"

#include <map>
#include <memory>
#include <string_view>

namespace trembler {

/// The number of subscriptions to each property. A world and its subscriptions share it.
class Wants {
public:
    [[nodiscard]] bool contains(PropertyInfo const& property) const {
        return counts_.contains(property.text.key);
    }
    [[nodiscard]] std::map<std::string_view, int> const& counts() const { return counts_; }
    void add(PropertyInfo const& property);
    /// Reverts one add().
    void remove(PropertyInfo const& property);
    /// Whether any number has changed since the last call.
    [[nodiscard]] bool takeChanged();

private:
    std::map<std::string_view, int> counts_; // above zero, by key of the property
    bool changed_ = false;
};

/// While it exists, a resolver or derived property of a world counts as read, so that it is computed even if
/// no component reads it; see World::want(). Its destructor ends it; it may outlive its world. It may be
/// created, moved and ended between frames only, by one thread at a time.
class [[nodiscard]] Subscription {
public:
    /// A subscription to no property.
    Subscription() = default;
    Subscription(std::shared_ptr<Wants> const& wants, PropertyInfo const& property);
    Subscription(Subscription&& other) noexcept;
    Subscription& operator=(Subscription&& other) noexcept;
    Subscription(Subscription const&) = delete;
    Subscription& operator=(Subscription const&) = delete;
    ~Subscription() { end(); }

    /// Does nothing if it has ended already or its world no longer exists.
    void end();
    /// Whether it still counts: it has not ended, and its world exists.
    [[nodiscard]] explicit operator bool() const { return !wants_.expired(); }

private:
    std::weak_ptr<Wants> wants_;
    PropertyInfo const* property_ = nullptr;
};

} // namespace trembler
