#include "runtime/frame/frame_resolver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trembler {

void FrameResolver::advance(Access& access) {
    double wanted = 1;
    access.forCalls<SplitFrame>([&](SplitFrame const& call, CallOrigin const&) {
        if (std::isfinite(call.longest) && call.longest > 0) {
            wanted = std::max(wanted, frameDuration / call.longest);
        }
    });
    auto const& settings = access.read<FrameSettings>();
    std::int32_t const stated = settings.empty() ? FrameSettings::automatic : settings.values().front().parts;
    int const parts = roundedParts(stated == FrameSettings::automatic ? wanted : stated);
    if (parts != access.provided<FrameParts>().parts) {
        access.provide<FrameParts>().parts = parts;
        access.event(fmt::format("frame in {} part{}", parts, parts == 1 ? "" : "s"),
                     std::initializer_list<ObjectId>{}, {});
    }
}

} // namespace trembler
