#include "runtime/component/component.hpp"

namespace trembler {

std::string_view nameOf(Activity activity) {
    switch (activity) {
    case Activity::absent:
        return "absent";
    case Activity::asleep:
        return "asleep";
    case Activity::active:
        return "active";
    }
    return "";
}

void Component::openSinks(FrameContext const& context, std::size_t chunks, Phase phase) {
    sinks_.clear();
    if (context.tracing) {
        for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
            sinks_.emplace_back(context.store, context.when, context.component,
                                static_cast<std::uint32_t>(chunk), phase, info_.text.name);
        }
    }
}

} // namespace trembler
