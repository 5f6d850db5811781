#include "lua/reference/reference.hpp"

#include "lua/reference/examples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <functional>

namespace trembler::lua {
namespace {

using Visit = std::function<void(FieldVisitor&)>;

std::vector<ReferenceField> fieldsOf(Visit const& visit);

/// Adds the fields that it visits, each key once. A choice can be forced to a value, so that fields that
/// depend on it appear.
class FieldCollector final : public FieldVisitor {
public:
    FieldCollector(std::vector<ReferenceField>& fields, std::string_view forced, int index)
        : fields_(fields), forced_(forced), index_(index) {}

    void boolean(FieldInfo const& info, bool&) override { (void)add(info, FieldKind::boolean); }
    void integer(FieldInfo const& info, std::int32_t&) override { (void)add(info, FieldKind::integer); }
    void number(FieldInfo const& info, double&) override { (void)add(info, FieldKind::number); }
    void vector(FieldInfo const& info, Vec2&) override { (void)add(info, FieldKind::vector); }
    void text(FieldInfo const& info, std::string&) override { (void)add(info, FieldKind::text); }
    void object(FieldInfo const& info, ObjectId&) override { (void)add(info, FieldKind::object); }
    void choice(FieldInfo const& info, ChoiceField field) override {
        if (ReferenceField* const made = add(info, FieldKind::choice)) {
            made->choices.assign(field.names.begin(), field.names.end());
        }
        if (info.key == forced_) {
            field.index = index_;
        }
    }
    void list(FieldInfo const& info, ListField& list) override {
        if (list.size() == 0) {
            list.resize(1);
        }
        bool const entriesHaveFields = list.elementsHaveFields();
        auto entry = fieldsOf([&](FieldVisitor& visitor) { list.visitElement(0, visitor); });
        if (ReferenceField* const made = add(info, FieldKind::list)) {
            made->entriesHaveFields = entriesHaveFields;
            made->entry = std::move(entry);
        }
    }

private:
    ReferenceField* add(FieldInfo const& info, FieldKind kind) {
        if (std::any_of(fields_.begin(), fields_.end(),
                        [&](ReferenceField const& known) { return known.info.key == info.key; })) {
            return nullptr;
        }
        fields_.push_back({.info = info, .kind = kind});
        return &fields_.back();
    }

    std::vector<ReferenceField>& fields_;
    std::string_view forced_;
    int index_;
};

std::vector<ReferenceField> fieldsOf(Visit const& visit) {
    std::vector<ReferenceField> fields;
    FieldCollector all(fields, {}, 0);
    visit(all);
    for (std::size_t i = 0; i < fields.size(); ++i) {
        std::string_view const key = fields[i].info.key;
        for (std::size_t choice = 0; choice < fields[i].choices.size(); ++choice) {
            FieldCollector more(fields, key, static_cast<int>(choice));
            visit(more);
        }
    }
    return fields;
}

template <class T>
T initialOf(CallDescription const& call, FieldPlace const& place) {
    T value{};
    std::memcpy(&value, call.initial.data() + place.offset, std::min(sizeof value, place.size));
    return value;
}

std::string initialText(CallDescription const& call, FieldPlace const& place) {
    if (place.info.required) {
        return {};
    }
    switch (place.kind) {
    case FieldKind::boolean:
        return initialOf<bool>(call, place) ? "true" : "false";
    case FieldKind::integer:
        return fmt::format("{}", initialOf<std::int32_t>(call, place));
    case FieldKind::whole:
        return fmt::format("{}", initialOf<std::uint64_t>(call, place));
    case FieldKind::number:
        return fmt::format("{:g}", initialOf<double>(call, place));
    case FieldKind::vector: {
        Vec2 const value = initialOf<Vec2>(call, place);
        return fmt::format("vec2({:g}, {:g})", value.x, value.y);
    }
    case FieldKind::choice: {
        auto const index = static_cast<std::size_t>(initialOf<int>(call, place));
        return index < place.choices.size() ? fmt::format("\"{}\"", place.choices[index]) : std::string();
    }
    default:
        return "none";
    }
}

ReferenceFunction functionOf(RoleInfo const& role, CallDescription const& call) {
    ReferenceFunction made{.role = &role, .call = &call};
    for (FieldPlace const& place : call.arguments) {
        made.arguments.push_back({.info = place.info,
                                  .kind = place.kind,
                                  .choices = {place.choices.begin(), place.choices.end()},
                                  .initial = initialText(call, place)});
    }
    made.example = functionExample(made);
    return made;
}

constexpr std::array<std::string_view, 22> keywords{
    "and", "break", "do",  "else", "elseif", "end",    "false",  "for",  "function", "goto",  "if",
    "in",  "local", "nil", "not",  "or",     "repeat", "return", "then", "true",     "until", "while"};

bool needsNoQuotes(std::string_view name) {
    return !name.empty() && std::isdigit(static_cast<unsigned char>(name.front())) == 0 &&
           std::all_of(name.begin(), name.end(),
                       [](char c) {
                           return c == '_' || (static_cast<unsigned char>(c) < 0x80 &&
                                               std::isalnum(static_cast<unsigned char>(c)) != 0);
                       }) &&
           std::find(keywords.begin(), keywords.end(), name) == keywords.end();
}

ReferenceProperty propertyOf(PropertyInfo const& info) {
    ReferenceProperty made{.info = &info};
    if (info.kind == PropertyKind::object) {
        made.home = info.text.place == PropertyPlace::world ? PropertyHome::world : PropertyHome::objects;
        auto const value = info.makeValue();
        made.fields = fieldsOf([&](FieldVisitor& visitor) { value->visit(visitor); });
    } else {
        made.home = PropertyHome::state;
        auto const slot = info.makeSlot();
        made.fields = fieldsOf([&](FieldVisitor& visitor) { slot->visitCurrent(visitor); });
    }
    made.body = propertyExampleBody(made);
    made.example = propertyExample(made);
    return made;
}

} // namespace

Reference makeReference(Registry const& registry) {
    Reference all;
    for (PropertyInfo const* const info : registry.objectProperties()) {
        all.properties.push_back(propertyOf(*info));
    }
    std::stable_partition(
        all.properties.begin(), all.properties.end(),
        [](ReferenceProperty const& property) { return property.home == PropertyHome::objects; });
    std::vector<RoleInfo const*> roles;
    for (Registration const& registration : registry.components()) {
        ComponentInfo const& component = *registration.info;
        for (PropertyInfo const* const offered : component.offers) {
            auto known = std::find_if(
                all.properties.begin(), all.properties.end(),
                [&](ReferenceProperty const& property) { return property.info->type == offered->type; });
            if (known == all.properties.end()) {
                if (offered->fields == nullptr) {
                    continue; // scripts cannot read it
                }
                all.properties.push_back(propertyOf(*offered));
                known = all.properties.end() - 1;
            }
            known->offeredBy.emplace_back(component.text.name);
        }
        RoleInfo const* const role = component.roleInfo;
        if (role != nullptr && std::find(roles.begin(), roles.end(), role) == roles.end()) {
            roles.push_back(role);
            for (CallDescription const& call : role->calls) {
                all.functions.push_back(functionOf(*role, call));
            }
        }
    }
    return all;
}

std::string_view scriptName(PropertyInfo const& info) {
    return needsNoQuotes(info.text.name) ? info.text.name : info.text.key;
}

std::string expressionOf(ReferenceProperty const& property) {
    std::string_view const name = scriptName(*property.info);
    std::string_view const of = property.home == PropertyHome::objects ? "object" : "world";
    return memberOf(of, name);
}

std::string memberOf(std::string_view of, std::string_view name) {
    return needsNoQuotes(name) ? fmt::format("{}.{}", of, name) : fmt::format("{}[\"{}\"]", of, name);
}

std::string kindText(ReferenceField const& field) {
    switch (field.kind) {
    case FieldKind::boolean:
        return "true or false";
    case FieldKind::integer:
    case FieldKind::whole:
        return "whole number";
    case FieldKind::number:
        return "number";
    case FieldKind::vector:
        return "vec2";
    case FieldKind::text:
        return "text";
    case FieldKind::object:
        return "object";
    case FieldKind::part:
        return "name of a part";
    case FieldKind::choice: {
        std::string all;
        for (std::string const& choice : field.choices) {
            all += (all.empty() ? "" : ", ") + choice;
        }
        return "one of " + all;
    }
    case FieldKind::list:
        break;
    }
    return "list";
}

std::string rangeText(ReferenceField const& field) {
    bool const numeric = field.kind == FieldKind::number || field.kind == FieldKind::integer ||
                         field.kind == FieldKind::whole || field.kind == FieldKind::vector;
    constexpr double least = -std::numeric_limits<double>::max();
    constexpr double most = std::numeric_limits<double>::max();
    FieldInfo const& info = field.info;
    if (!numeric || (info.minimum == least && info.maximum == most)) {
        return {};
    }
    if (info.maximum == most) {
        return fmt::format("{} {:g}", info.minimumExcluded ? "above" : "from", info.minimum);
    }
    if (info.minimum == least) {
        return fmt::format("up to {:g}", info.maximum);
    }
    return info.minimumExcluded ? fmt::format("above {:g}, up to {:g}", info.minimum, info.maximum)
                                : fmt::format("{:g} to {:g}", info.minimum, info.maximum);
}

} // namespace trembler::lua
