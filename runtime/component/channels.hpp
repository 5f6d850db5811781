// All channels of a world, by role.
#pragma once

#include "runtime/component/channel.hpp"

#include <memory>
#include <typeindex>
#include <unordered_map>

namespace trembler {

class Channels {
public:
    /// `callers` assigns identities to the callers outside that feed a role; it must outlive the channels.
    explicit Channels(Callers& callers) : callers_(callers) {}

    template <ResolverRole Role>
    [[nodiscard]] Channel<Role>& of() {
        auto& channel = channels_[typeid(Role)];
        if (!channel) {
            auto made = std::make_unique<Channel<Role>>();
            if constexpr (FedFromOutside<Role>) {
                made->openToOutside(callers_.addOutside(Role::fedBy));
            }
            channel = std::move(made);
        }
        return static_cast<Channel<Role>&>(*channel);
    }

    /// Removes all sources. The interactions of the world are bound afterwards, in registration order.
    void clearSources() {
        for (auto& [role, channel] : channels_) {
            channel->clearSources();
        }
    }

private:
    Callers& callers_;
    std::unordered_map<std::type_index, std::unique_ptr<ChannelBase>> channels_; // order never matters
};

} // namespace trembler
