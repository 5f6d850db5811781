#include "insight/whatif/settable.hpp"

#include "runtime/placement.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace trembler::insight {
namespace {

/// Describes the fields that can be set.
class FieldsToSet final : public FieldVisitor {
public:
    FieldsToSet(PropertyInfo const& property, std::vector<SettableField>& into)
        : property_(property), into_(into) {}

    void boolean(FieldInfo const& info, bool& value) override {
        add(info, FieldType::boolean, {value ? 1.0 : 0.0, 0});
    }
    void integer(FieldInfo const& info, std::int32_t& value) override {
        add(info, FieldType::integer, {static_cast<double>(value), 0});
    }
    void number(FieldInfo const& info, double& value) override { add(info, FieldType::number, {value, 0}); }
    void vector(FieldInfo const& info, Vec2& value) override {
        add(info, FieldType::vector, {value.x, value.y});
    }
    void choice(FieldInfo const& info, ChoiceField field) override {
        add(info, FieldType::choice, {static_cast<double>(field.index), 0});
        into_.back().choices.assign(field.names.begin(), field.names.end());
    }
    void text(FieldInfo const&, std::string&) override {}
    void object(FieldInfo const&, ObjectId&) override {}
    void list(FieldInfo const&, ListField&) override {}

private:
    void add(FieldInfo const& info, FieldType type, FieldAmount const& now) {
        into_.push_back({&property_,
                         std::string(info.key),
                         std::string(info.unit),
                         std::string(info.meaning),
                         type,
                         info.minimum,
                         info.maximum,
                         {},
                         now});
    }

    PropertyInfo const& property_;
    std::vector<SettableField>& into_;
};

/// Sets one field.
class FieldSetter final : public FieldVisitor {
public:
    FieldSetter(std::string_view field, FieldAmount const& amount) : field_(field), amount_(amount) {}

    [[nodiscard]] bool changed() const { return changed_; }

    void boolean(FieldInfo const& info, bool& value) override { give(info, value, amount_.x != 0); }
    void integer(FieldInfo const& info, std::int32_t& value) override {
        give(info, value, static_cast<std::int32_t>(std::lround(within(info, amount_.x))));
    }
    void number(FieldInfo const& info, double& value) override {
        double const wanted = within(info, amount_.x);
        if (!(info.minimumExcluded && wanted <= info.minimum)) {
            give(info, value, wanted);
        }
    }
    void vector(FieldInfo const& info, Vec2& value) override {
        give(info, value, Vec2{within(info, amount_.x), within(info, amount_.y)});
    }
    void choice(FieldInfo const& info, ChoiceField field) override {
        int const last = static_cast<int>(field.names.size()) - 1;
        give(info, field.index, static_cast<int>(std::clamp(amount_.x, 0.0, static_cast<double>(last))));
    }
    void text(FieldInfo const&, std::string&) override {}
    void object(FieldInfo const&, ObjectId&) override {}
    void list(FieldInfo const&, ListField&) override {}

private:
    static double within(FieldInfo const& info, double value) {
        return std::clamp(std::isfinite(value) ? value : 0.0, info.minimum, info.maximum);
    }
    template <class T>
    void give(FieldInfo const& info, T& value, T const& wanted) {
        if (info.key == field_ && !(value == wanted)) {
            value = wanted;
            changed_ = true;
        }
    }

    std::string_view field_;
    FieldAmount amount_;
    bool changed_ = false;
};

bool breaksRule(Store const& store, std::span<ObjectRule const> rules, ObjectId object,
                std::string_view property) {
    return std::any_of(rules.begin(), rules.end(), [&](ObjectRule const& rule) {
        if (rule.property->text.key != property) {
            return false;
        }
        if (rule.check) {
            return rule.check(store, object).has_value();
        }
        std::vector<ObjectFault> const faults = rule.checkAll(store);
        return std::any_of(faults.begin(), faults.end(),
                           [&](ObjectFault const& fault) { return fault.object == object; });
    });
}

} // namespace

std::vector<SettableField> settableFields(World const& world, ObjectId object) {
    std::set<std::string_view> read;
    for (ComponentStatus const& status : world.status()) {
        if (status.activity != Activity::absent) {
            for (auto const* list : {&status.info->reads, &status.info->writes}) {
                for (PropertyInfo const* info : *list) {
                    read.insert(info->text.key);
                }
            }
        }
    }
    std::vector<SettableField> all;
    for (ColumnBase const* column : world.store().columns()) {
        PropertyInfo const& info = column->info();
        bool const hidden = info.text.place == PropertyPlace::hidden;
        bool const ofPlace = info.type == typeid(Position) || info.type == typeid(Rotation);
        if (!hidden && !ofPlace && column->has(object) && read.count(info.text.key) > 0) {
            FieldsToSet fields(info, all);
            column->visitCopy(object, fields);
        }
    }
    return all;
}

bool setField(World& world, std::span<ObjectRule const> rules, ObjectId object, std::string_view property,
              std::string_view field, FieldAmount const& amount) {
    std::vector<SettableField> const allowed = settableFields(world, object);
    auto const found = std::find_if(allowed.begin(), allowed.end(), [&](SettableField const& each) {
        return each.property->text.key == property && each.key == field;
    });
    if (found == allowed.end() || found->now == amount) {
        return false;
    }
    Store& store = world.store();
    ColumnBase& column = store.column(*found->property);
    bool const broken = breaksRule(store, rules, object, property);
    FieldSetter setter(field, amount);
    column.visit(object, setter);
    if (setter.changed() && !broken && breaksRule(store, rules, object, property)) {
        FieldSetter back(field, found->now);
        column.visit(object, back);
        return false;
    }
    if (setter.changed()) {
        column.touch();
    }
    return setter.changed();
}

} // namespace trembler::insight
