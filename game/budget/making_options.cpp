#include "game/budget/making_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trembler::budget {
namespace {

bool possible(World const& world, ComponentInfo const& info) {
    auto const inhabited = [&](PropertyInfo const* property) {
        ColumnBase const* const column = world.store().findColumn(*property);
        return column != nullptr && !column->empty();
    };
    return std::all_of(info.neededAll.begin(), info.neededAll.end(), inhabited) &&
           (info.neededAny.empty() || std::any_of(info.neededAny.begin(), info.neededAny.end(), inhabited));
}

} // namespace

RecordedChange toLevel(std::string_view effect, std::string_view level) {
    RecordedChange change;
    change.kind = RecordedChange::Kind::detail;
    change.subject = effect;
    change.level = level;
    return change;
}

RecordedChange toPeriod(std::string_view component, int period) {
    RecordedChange change;
    change.kind = RecordedChange::Kind::period;
    change.subject = component;
    change.value = period;
    return change;
}

RecordedChange toSetting(std::string_view property, std::string_view field, double value) {
    RecordedChange change;
    change.kind = RecordedChange::Kind::setting;
    change.subject = property;
    change.field = field;
    change.value = value;
    return change;
}

std::vector<ComponentStatus> levelsOf(World const& world, std::string_view effect) {
    std::vector<ComponentStatus> levels;
    for (ComponentStatus const& status : world.status()) {
        ComponentText const& text = status.info->text;
        if (text.effect == effect && !text.level.empty() && possible(world, *status.info)) {
            levels.push_back(status);
        }
    }
    return levels;
}

std::optional<ComponentStatus> working(std::vector<ComponentStatus> const& levels) {
    auto const at = std::find_if(levels.begin(), levels.end(),
                                 [](ComponentStatus const& s) { return s.activity != Activity::absent; });
    return at == levels.end() ? std::nullopt : std::optional(*at);
}

void runEvery(Option& option, std::string_view component, int period) {
    option.makes.push_back(toPeriod(component, period));
    option.work /= period;
    if (period > 1) {
        option.name = fmt::format("{}, every {} frames", option.name, period);
        option.lessOften = true;
    }
}

Error together(Error const& a, Error const& b) {
    return {std::hypot(a.metres, b.metres), std::hypot(a.share, b.share)};
}

} // namespace trembler::budget
