// All channels of a world, by role.
#pragma once

#include "runtime/component/call.hpp"

#include <memory>
#include <typeindex>
#include <unordered_map>

namespace trembler {

class Channels {
public:
    template <ResolverRole Role>
    [[nodiscard]] Channel<Role>& of() {
        auto& channel = channels_[typeid(Role)];
        if (!channel) {
            channel = std::make_unique<Channel<Role>>();
        }
        return static_cast<Channel<Role>&>(*channel);
    }

    /// Forgets who calls, before all interactions are bound anew in registration order.
    void clearSources() {
        for (auto& [role, channel] : channels_) {
            channel->clearSources();
        }
    }

private:
    std::unordered_map<std::type_index, std::unique_ptr<ChannelBase>> channels_; // order never matters
};

} // namespace trembler
