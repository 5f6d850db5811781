#include "insight/why/story/step.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace trembler::insight {
namespace {

struct KindName {
    std::string_view event;
    StepKind kind;
};
constexpr std::array<KindName, 15> namedKinds{{{"contact begun", StepKind::contact},
                                               {"contact brief", StepKind::contact},
                                               {"contact ended", StepKind::apart},
                                               {"on", StepKind::on},
                                               {"off", StepKind::off},
                                               {"magnet on", StepKind::magnetOn},
                                               {"magnet off", StepKind::magnetOff},
                                               {"attracted", StepKind::pull},
                                               {"repelled", StepKind::push},
                                               {"enters the liquid", StepKind::liquid},
                                               {"grabbed", StepKind::grabbed},
                                               {"released", StepKind::released},
                                               {"cut", StepKind::cut},
                                               {"removed", StepKind::removed},
                                               {"leaves the liquid", StepKind::other}}};

} // namespace

Step stepFor(Event const& event) {
    Step step;
    step.kind = kindOf(event).value_or(StepKind::other);
    step.event = event.id;
    step.frame = event.frame;
    step.component = event.component;
    step.what = event.event;
    step.objects = event.objects;
    return step;
}

std::optional<StepKind> kindOf(Event const& event) {
    if (event.phase == Phase::goal) {
        return StepKind::goal;
    }
    if (event.phase == Phase::interaction) {
        bool const turning = event.event == "turns fast enough" || event.event == "turns too slowly";
        return turning ? std::optional(StepKind::other) : std::nullopt;
    }
    static constexpr std::array<std::string_view, 4> between{"connected", "disconnected",
                                                             "no longer attracted", "no longer repelled"};
    if (event.component == "Frame" ||
        std::find(between.begin(), between.end(), event.event) != between.end()) {
        return std::nullopt;
    }
    auto const at = std::find_if(namedKinds.begin(), namedKinds.end(),
                                 [&](KindName const& named) { return named.event == event.event; });
    return at == namedKinds.end() ? StepKind::other : at->kind;
}

} // namespace trembler::insight
