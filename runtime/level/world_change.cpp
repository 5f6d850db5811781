#include "runtime/level/world_change.hpp"

#include "runtime/level/suggestion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace trembler {
namespace {

using Kind = RecordedChange::Kind;

/// Finds a field that is a number by its key, and sets it if it is told to.
class NumberField final : public FieldVisitor {
public:
    NumberField(std::string key, std::optional<double> set) : key_(std::move(key)), set_(set) {}
    [[nodiscard]] std::optional<double> found() const { return found_; }
    [[nodiscard]] std::vector<std::string> const& known() const { return known_; }
    [[nodiscard]] std::string const& wrong() const { return wrong_; }

    void boolean(FieldInfo const&, bool&) override {}
    void integer(FieldInfo const& info, std::int32_t& value) override {
        double number = value;
        if (take(info, number) && number != std::trunc(number)) {
            wrong_ = fmt::format("is {}; expected a whole number", number);
        } else if (wrong_.empty()) {
            value = static_cast<std::int32_t>(number);
        }
    }
    void number(FieldInfo const& info, double& value) override { take(info, value); }
    void vector(FieldInfo const&, Vec2&) override {}
    void text(FieldInfo const&, std::string&) override {}
    void object(FieldInfo const&, ObjectId&) override {}
    void choice(FieldInfo const&, ChoiceField) override {}
    void list(FieldInfo const&, ListField&) override {}

private:
    bool take(FieldInfo const& info, double& value) {
        known_.emplace_back(info.key);
        if (info.key != key_) {
            return false;
        }
        found_ = value;
        if (!set_) {
            return true;
        }
        // Not a number is in no range.
        if (!(*set_ >= info.minimum && *set_ <= info.maximum) ||
            (info.minimumExcluded && *set_ == info.minimum)) {
            wrong_ = fmt::format("is {}; expected {} to {}", *set_, info.minimum, info.maximum);
            return true;
        }
        value = *set_;
        return true;
    }

    std::string key_;
    std::optional<double> set_;
    std::optional<double> found_;
    std::vector<std::string> known_;
    std::string wrong_;
};

PropertyInfo const& settingOf(Registry const& registry, RecordedChange const& change) {
    PropertyInfo const* const info = registry.objectProperty(change.subject);
    if (info == nullptr || info->text.place != PropertyPlace::world) {
        std::vector<std::string_view> known;
        for (PropertyInfo const* property : registry.objectProperties()) {
            if (property->text.place == PropertyPlace::world) {
                known.push_back(property->text.key);
            }
        }
        throw std::invalid_argument(fmt::format("the world has no property '{}'; it may have: {}",
                                                change.subject, fmt::join(known, ", ")));
    }
    return *info;
}

void throwIfWrong(RecordedChange const& change, NumberField const& field) {
    if (!field.found()) {
        throw std::invalid_argument(fmt::format("'{}' has no number '{}'; it has: {}", change.subject,
                                                change.field, fmt::join(field.known(), ", ")));
    }
    if (!field.wrong().empty()) {
        throw std::invalid_argument(
            fmt::format("'{}' of '{}' {}", change.field, change.subject, field.wrong()));
    }
}

// In a file a component goes by its full title only.
void checkTitle(Registry const& registry, RecordedChange const& change) {
    std::vector<std::string> titles;
    for (Registration const& registration : registry.components()) {
        titles.push_back(title(*registration.info));
        if (titles.back() == change.subject) {
            return;
        }
    }
    throw std::invalid_argument(
        fmt::format("there is no component '{}'; there are: {}", change.subject, fmt::join(titles, ", ")));
}

int asPeriod(RecordedChange const& change) {
    if (!(change.value >= 1 && change.value <= 3600) || change.value != std::trunc(change.value)) {
        throw std::invalid_argument(fmt::format("the period of '{}' is {}; expected 1 to 3600 whole frames",
                                                change.subject, change.value));
    }
    return static_cast<int>(change.value);
}

void applySetting(Registry const& registry, World& world, RecordedChange const& change) {
    PropertyInfo const& info = settingOf(registry, change);
    NumberField field(change.field, change.value);
    auto const trial = info.makeValue(); // what is wrong must not be half done
    trial->visit(field);
    throwIfWrong(change, field);
    Store& store = world.store();
    ObjectId const owner = store.find("world");
    ColumnBase& column = store.column(info);
    column.addDefault(owner);
    NumberField real(change.field, change.value);
    column.visit(owner, real);
}

} // namespace

void apply(Registry const& registry, World& world, RecordedChange const& change) {
    switch (change.kind) {
    case Kind::detail:
        return world.setDetail(change.subject, change.level);
    case Kind::period:
        checkTitle(registry, change);
        return world.setPeriod(change.subject, asPeriod(change));
    case Kind::setting:
        return applySetting(registry, world, change);
    }
}

bool holds(Registry const& registry, World const& world, RecordedChange const& change) {
    switch (change.kind) {
    case Kind::detail: {
        auto const at = world.options().detail.find(change.subject);
        return at == world.options().detail.end() ? change.level.empty() : at->second == change.level;
    }
    case Kind::period: {
        auto const all = world.status();
        return std::any_of(all.begin(), all.end(), [&](ComponentStatus const& status) {
            return title(*status.info) == change.subject && status.period == change.value;
        });
    }
    case Kind::setting: {
        PropertyInfo const& info = settingOf(registry, change);
        NumberField field(change.field, std::nullopt);
        ColumnBase const* const column = world.store().findColumn(info);
        ObjectId const owner = world.store().find("world");
        if (column != nullptr && column->has(owner)) {
            column->visitCopy(owner, field);
        } else {
            info.makeValue()->visit(field);
        }
        return field.found() == change.value;
    }
    }
    return false;
}

std::vector<std::optional<std::string>> faultsIn(Registry const& registry,
                                                 std::span<RecordedChange const> changes) {
    World scratch(registry); // without an object, and never started
    scratch.store().create("world");
    std::vector<std::optional<std::string>> faults;
    for (RecordedChange const& change : changes) {
        try {
            apply(registry, scratch, change);
            faults.emplace_back(std::nullopt);
        } catch (std::invalid_argument const& error) {
            faults.emplace_back(error.what());
        }
    }
    return faults;
}

std::string inWords(RecordedChange const& change) {
    switch (change.kind) {
    case Kind::detail:
        return fmt::format("{}: {}", change.subject,
                           change.level.empty() ? "as the scene needs it" : change.level);
    case Kind::period:
        return fmt::format("{}: every {} frames", change.subject, change.value);
    case Kind::setting:
        return fmt::format("{}: {} {}", change.subject, change.field, change.value);
    }
    return {};
}

std::vector<RecordedChange> differences(Registry const& registry, WorldOptions const& from,
                                        WorldOptions const& to) {
    std::vector<RecordedChange> changes;
    auto const add = [&](Kind kind, std::string const& subject, std::string const& level, double value) {
        RecordedChange change;
        change.kind = kind;
        change.subject = subject;
        change.level = level;
        change.value = value;
        changes.push_back(std::move(change));
    };
    for (auto const& [effect, level] : from.detail) {
        if (!to.detail.contains(effect)) {
            add(Kind::detail, effect, "", 0);
        }
    }
    for (auto const& [effect, level] : to.detail) {
        auto const at = from.detail.find(effect);
        if (at == from.detail.end() || at->second != level) {
            add(Kind::detail, effect, level, 0);
        }
    }
    auto const usual = [&](std::string const& component) {
        for (Registration const& registration : registry.components()) {
            if (title(*registration.info) == component) {
                return registration.period;
            }
        }
        return 1;
    };
    for (auto const& [component, period] : from.periods) {
        if (!to.periods.contains(component) && period != usual(component)) {
            add(Kind::period, component, "", usual(component));
        }
    }
    for (auto const& [component, period] : to.periods) {
        auto const at = from.periods.find(component);
        if ((at == from.periods.end() ? usual(component) : at->second) != period) {
            add(Kind::period, component, "", period);
        }
    }
    return changes;
}

} // namespace trembler
