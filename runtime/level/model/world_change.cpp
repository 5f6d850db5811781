#include "runtime/level/model/world_change.hpp"

#include "runtime/property/idle_visitor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace trembler {
namespace {

using Kind = RecordedChange::Kind;

/// Finds a number field by its key, and sets it if `set` has a value.
class NumberField final : public IdleVisitor {
public:
    NumberField(std::string_view key, std::optional<double> set) : key_(key), set_(set) {}
    [[nodiscard]] std::optional<double> found() const { return found_; }

    void integer(FieldInfo const& info, std::int32_t& value) override {
        double number = value;
        take(info, number);
        value = static_cast<std::int32_t>(number);
    }
    void number(FieldInfo const& info, double& value) override { take(info, value); }

private:
    void take(FieldInfo const& info, double& value) {
        if (info.key == key_) {
            found_ = value;
            value = set_.value_or(value);
        }
    }

    std::string_view key_;
    std::optional<double> set_;
    std::optional<double> found_;
};

void applySetting(Registry const& registry, World& world, RecordedChange const& change) {
    PropertyInfo const& info = *registry.objectProperty(change.subject);
    Store& store = world.store();
    ObjectId const owner = store.find("world");
    ColumnBase& column = store.column(info);
    column.addDefault(owner);
    NumberField field(change.field, change.value);
    column.visit(owner, field);
}

} // namespace

void apply(Registry const& registry, World& world, RecordedChange const& change) {
    if (auto const fault = faultIn(registry, world, change)) {
        throw std::invalid_argument(inWords(*fault));
    }
    switch (change.kind) {
    case Kind::detail:
        return world.setDetail(change.subject, change.level);
    case Kind::period:
        return world.setPeriod(change.subject, static_cast<int>(change.value));
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
        PropertyInfo const* const property = registry.objectProperty(change.subject);
        if (property == nullptr) {
            return false;
        }
        PropertyInfo const& info = *property;
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
