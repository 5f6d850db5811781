#include "runtime/world/subscription.hpp"

#include <utility>

namespace trembler {

void Wants::add(PropertyInfo const& property) {
    ++counts_[property.text.key];
    changed_ = true;
}

void Wants::remove(PropertyInfo const& property) {
    auto const at = counts_.find(property.text.key);
    if (at != counts_.end() && --at->second == 0) {
        counts_.erase(at);
    }
    changed_ = true;
}

bool Wants::takeChanged() {
    return std::exchange(changed_, false);
}

Subscription::Subscription(std::shared_ptr<Wants> const& wants, PropertyInfo const& property)
    : wants_(wants), property_(&property) {
    wants->add(property);
}

Subscription::Subscription(Subscription&& other) noexcept
    : wants_(std::exchange(other.wants_, {})), property_(other.property_) {}

Subscription& Subscription::operator=(Subscription&& other) noexcept {
    if (this != &other) {
        end();
        wants_ = std::exchange(other.wants_, {});
        property_ = other.property_;
    }
    return *this;
}

void Subscription::end() {
    if (std::shared_ptr<Wants> const wants = std::exchange(wants_, {}).lock()) {
        wants->remove(*property_);
    }
}

} // namespace trembler
