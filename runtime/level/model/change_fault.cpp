#include "runtime/level/model/change_fault.hpp"

#include "runtime/level/property/field_outline.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace trembler {
namespace {

/// All settings that a recording may change, of one property or of all, in the form "solver.substeps (0 to
/// 64)".
std::vector<std::string> settings(Registry const& registry, PropertyInfo const* of = nullptr) {
    std::vector<std::string> all;
    for (PropertyInfo const* info : registry.objectProperties()) {
        if (info->text.place != PropertyPlace::world || (of != nullptr && of != info)) {
            continue;
        }
        for (FieldOutline const& field : outlineOf(*info->makeValue())) {
            if (isAccuracySetting(field)) {
                AccuracyRange const& range = field.info.accuracy;
                all.push_back(fmt::format("{}.{} ({}{} to {})", info->text.key, field.info.key,
                                          range.orAutomatic ? "0, or " : "", range.from, range.to));
            }
        }
    }
    return all;
}

std::string oneOf(std::vector<std::string> const& all, std::string_view of) {
    return all.empty() ? fmt::format("no change: there is no {}", of)
                       : fmt::format("one of the {}s: {}", of, fmt::join(all, ", "));
}

std::optional<ChangeFault> faultInSetting(Registry const& registry, RecordedChange const& change) {
    PropertyInfo const* const info = registry.objectProperty(change.subject);
    auto const expected = [&] { return oneOf(settings(registry), "accuracy setting"); };
    if (info == nullptr || info->text.place != PropertyPlace::world) {
        return ChangeFault{fmt::format("the world has no property '{}'", change.subject), expected()};
    }
    auto const fields = outlineOf(*info->makeValue());
    auto const field = std::find_if(fields.begin(), fields.end(), [&](FieldOutline const& outline) {
        return outline.info.key == change.field && isNumber(outline);
    });
    if (field == fields.end()) {
        return ChangeFault{fmt::format("'{}' has no number '{}'", change.subject, change.field), expected()};
    }
    if (!isAccuracySetting(*field)) {
        return ChangeFault{
            fmt::format(
                "'{}' of '{}' is physics, no accuracy setting, and cannot be changed while a level runs",
                change.field, change.subject),
            expected()};
    }
    FieldInfo const& number = field->info;
    bool const inRange = number.accuracy.contains(change.value) && change.value >= number.minimum &&
                         change.value <= number.maximum &&
                         !(number.minimumExcluded && change.value == number.minimum);
    bool const whole = field->type != FieldType::integer || change.value == std::trunc(change.value);
    if (!inRange || !whole) { // NaN is in no range
        return ChangeFault{fmt::format("'{}' of '{}' is {}", change.field, change.subject, change.value),
                           fmt::format("{}a number from {} to {}{}",
                                       number.accuracy.orAutomatic ? "0, or " : "", number.accuracy.from,
                                       number.accuracy.to,
                                       field->type == FieldType::integer ? ", a whole one" : "")};
    }
    return std::nullopt;
}

// Files must name a component by its full title.
std::optional<ChangeFault> faultInPeriod(Registry const& registry, RecordedChange const& change) {
    std::vector<std::string> able;
    Registration const* found = nullptr;
    for (Registration const& registration : registry.components()) {
        std::string const name = title(*registration.info);
        if (name == change.subject) {
            found = &registration;
        }
        if (registration.longestPeriod > registration.period) {
            able.push_back(fmt::format("{} (1 to {})", name, registration.longestPeriod));
        }
    }
    std::string const expected = oneOf(able, "component that may miss frame");
    if (found == nullptr) {
        return ChangeFault{fmt::format("there is no component '{}'", change.subject), expected};
    }
    if (change.value == found->period) {
        return std::nullopt;
    }
    if (found->longestPeriod == found->period) {
        return ChangeFault{fmt::format("'{}' must not miss a frame, so its period cannot be changed while a "
                                       "level runs",
                                       change.subject),
                           expected};
    }
    if (!(change.value >= 1 && change.value <= found->longestPeriod) ||
        change.value != std::trunc(change.value)) {
        return ChangeFault{fmt::format("the period of '{}' is {}", change.subject, change.value),
                           fmt::format("1 to {} whole frames", found->longestPeriod)};
    }
    return std::nullopt;
}

std::optional<ChangeFault> faultInDetail(Registry const& registry, RecordedChange const& change) {
    std::vector<std::string> effects;
    std::vector<std::string> levels;
    auto const note = [](std::vector<std::string>& list, std::string_view word) {
        if (std::find(list.begin(), list.end(), word) == list.end()) {
            list.emplace_back(word);
        }
    };
    for (Registration const& registration : registry.components()) {
        ComponentText const& text = registration.info->text;
        if (text.level.empty()) {
            continue;
        }
        note(effects, text.effect);
        if (text.effect == change.subject) {
            note(levels, text.level);
            if (text.level == change.level && !registration.missing.empty()) {
                return ChangeFault{fmt::format("{}={} is not available: {}", change.subject, change.level,
                                               registration.missing),
                                   "a level that this program has"};
            }
        }
    }
    if (levels.empty()) {
        return ChangeFault{fmt::format("no effect '{}' has detail levels", change.subject),
                           fmt::format("one of the effects: {}", fmt::join(effects, ", "))};
    }
    if (!change.level.empty() && std::find(levels.begin(), levels.end(), change.level) == levels.end()) {
        return ChangeFault{fmt::format("{} has no detail level '{}'", change.subject, change.level),
                           fmt::format("one of the levels: {}", fmt::join(levels, ", "))};
    }
    return std::nullopt;
}

bool isFaithful(Registry const& registry, Store const& store, std::string_view effect,
                std::string_view level) {
    auto const all = registry.components();
    return std::none_of(all.begin(), all.end(), [&](Registration const& registration) {
        ComponentText const& text = registration.info->text;
        return text.effect == effect && text.level == level && registration.faithful != nullptr &&
               !registration.faithful(store);
    });
}

// A level file may state a level that is other physics; then no other level may replace it.
std::optional<ChangeFault> otherPhysics(Registry const& registry, World const& world,
                                        std::map<std::string, std::string> const& statedLevels,
                                        RecordedChange const& change) {
    auto const stated = statedLevels.find(change.subject);
    bool const isStated = stated != statedLevels.end();
    std::string_view const now = isStated ? std::string_view(stated->second) : std::string_view();
    auto const good = [&](std::string_view level) {
        return level == now ||
               ((!isStated || isFaithful(registry, world.store(), change.subject, now)) &&
                (level.empty() || isFaithful(registry, world.store(), change.subject, level)));
    };
    if (good(change.level)) {
        return std::nullopt;
    }
    std::vector<std::string> others;
    for (Registration const& registration : registry.components()) {
        ComponentText const& text = registration.info->text;
        std::string const quoted = fmt::format("'{}'", text.level);
        if (text.effect == change.subject && !text.level.empty() && good(text.level) &&
            std::find(others.begin(), others.end(), quoted) == others.end()) {
            others.push_back(quoted);
        }
    }
    return ChangeFault{
        fmt::format("in this level the detail level '{}' of {} changes the physics, not only its accuracy",
                    change.level.empty() ? "as the scene needs it" : change.level, change.subject),
        fmt::format("one of the levels: {}", fmt::join(others, ", "))};
}

} // namespace

std::optional<ChangeFault> faultIn(Registry const& registry, RecordedChange const& change) {
    switch (change.kind) {
    case RecordedChange::Kind::detail:
        return faultInDetail(registry, change);
    case RecordedChange::Kind::period:
        return faultInPeriod(registry, change);
    case RecordedChange::Kind::setting:
        return faultInSetting(registry, change);
    }
    return std::nullopt;
}

std::optional<ChangeFault> faultIn(Registry const& registry, World const& world,
                                   RecordedChange const& change) {
    return faultIn(registry, world, world.options().detail, change);
}

std::optional<ChangeFault> faultIn(Registry const& registry, World const& world,
                                   std::map<std::string, std::string> const& stated,
                                   RecordedChange const& change) {
    auto fault = faultIn(registry, change);
    return !fault && change.kind == RecordedChange::Kind::detail
               ? otherPhysics(registry, world, stated, change)
               : fault;
}

std::string inWords(ChangeFault const& fault) {
    return fmt::format("{}; expected {}", fault.message, fault.expected);
}

} // namespace trembler
