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

void Component::openSinks(FrameContext const& context, Phase phase) {
    if (!context.tracing) {
        sinks_.clear();
        return;
    }
    for (EventSink& sink : sinks_) { // those of its last run, which keep their memory
        sink.restart(context.when);
    }
    if (sinks_.empty()) {
        sinks_.emplace_back(context.store, context.when, context.component, 0, phase, info_.text.name);
    }
}

} // namespace trembler
