#include "puzzle/edit/inspect/inspector.hpp"

#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/inspect/field_list.hpp"
#include "puzzle/edit/tree/object_values.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "runtime/level/property/property_writer.hpp"

#include <algorithm>

namespace trembler::edit {
namespace {

std::vector<Json const*> entriesNamed(Json const& level, std::vector<std::string> const& names) {
    std::vector<Json const*> entries;
    for (std::string const& name : names) {
        if (Json const* const entry = findObject(level, name)) {
            entries.push_back(entry);
        }
    }
    return entries;
}

/// The properties of a place, by name.
std::vector<PropertyInfo const*> propertiesAt(GameData const& data, PropertyPlace place) {
    std::vector<PropertyInfo const*> infos;
    for (PropertyInfo const* const info : data.registry.objectProperties()) {
        if (info->text.place == place && info->text.key != "name" && info->text.key != "joint") {
            infos.push_back(info);
        }
    }
    std::sort(infos.begin(), infos.end(),
              [](PropertyInfo const* a, PropertyInfo const* b) { return a->text.name < b->text.name; });
    return infos;
}

/// Marks what differs between a property of the first object and the same of another one.
void mergeFields(std::vector<InspectedField>& fields, std::vector<InspectedField> const& others) {
    for (InspectedField& field : fields) {
        auto const other = std::find_if(others.begin(), others.end(),
                                        [&](InspectedField const& one) { return one.place == field.place; });
        if (other == others.end()) { // another form of a piece or a joint has no such field
            field.mixed = true;
            continue;
        }
        field.stated = field.stated || other->stated;
        if (field.type == FieldType::list) {
            field.mixed = field.mixed || field.value != other->value;
            if (field.entries.size() == other->entries.size()) {
                mergeFields(field.entries, other->entries);
            } else {
                field.entries.clear();
            }
        } else {
            field.mixed = field.mixed || field.value != other->value;
        }
    }
}

ValueOrigin originOf(Json const* own, bool fromPart, bool has) {
    if (own == nullptr) {
        return ValueOrigin::part;
    }
    if (!has) {
        return ValueOrigin::removed;
    }
    return fromPart ? ValueOrigin::changed : ValueOrigin::own;
}

/// One property of some objects; nothing if none of them has or removes it.
std::optional<InspectedProperty> inspectProperty(GameData const& data, Json const& level,
                                                 std::vector<Json const*> const& entries,
                                                 PropertyInfo const& info) {
    std::optional<InspectedProperty> found;
    bool onAll = true;
    bool first = true;
    bool const placement = info.text.place == PropertyPlace::placement;
    for (Json const* const entry : entries) {
        Json const* const own = ownStatement(*entry, info);
        bool const fromPart = !partStatement(data, *entry, info).is_null();
        Json value = effectiveStatement(data, *entry, info);
        bool const has = !value.is_null();
        if (!has && own == nullptr && !placement) {
            onAll = false;
            continue;
        }
        onAll = onAll && (has || placement);
        std::vector<InspectedField> fields;
        if (has || placement) {
            auto listed = fieldsOf(data, level, info, value);
            if (!listed) {
                continue; // it cannot be read, which is a problem
            }
            fields = std::move(*listed);
        }
        ValueOrigin const origin = originOf(own, fromPart, has);
        if (!found) {
            found = InspectedProperty{std::string(info.text.key), std::string(info.text.name),
                                      std::string(info.text.meaning), info.text.place, origin};
            found->marker = isMarker(info);
        } else if (found->origin != origin) {
            found->origin = ValueOrigin::mixed;
        }
        found->canReset = found->canReset || own != nullptr;
        found->canRemove = found->canRemove || (has && !placement);
        if (first || found->fields.empty()) {
            found->fields = std::move(fields);
        } else if (!fields.empty()) {
            mergeFields(found->fields, fields);
        }
        first = false;
    }
    if (found) {
        found->onAll = onAll;
    }
    return found;
}

} // namespace

std::vector<InspectedProperty> inspectObjects(GameData const& data, Json const& level,
                                              std::vector<std::string> const& names) {
    std::vector<InspectedProperty> properties;
    auto const entries = entriesNamed(level, names);
    if (entries.empty()) {
        return properties;
    }
    for (PropertyPlace const place : {PropertyPlace::placement, PropertyPlace::properties}) {
        for (PropertyInfo const* const info : propertiesAt(data, place)) {
            if (auto property = inspectProperty(data, level, entries, *info)) {
                properties.push_back(std::move(*property));
            }
        }
    }
    return properties;
}

std::vector<AddableProperty> addableProperties(GameData const& data, Json const& level,
                                               std::vector<std::string> const& names) {
    std::vector<AddableProperty> addable;
    auto const entries = entriesNamed(level, names);
    for (PropertyInfo const* const info : propertiesAt(data, PropertyPlace::properties)) {
        bool const missing = std::any_of(entries.begin(), entries.end(), [&](Json const* entry) {
            return effectiveStatement(data, *entry, *info).is_null();
        });
        if (missing) {
            addable.push_back(
                {std::string(info->text.key), std::string(info->text.name), std::string(info->text.meaning)});
        }
    }
    return addable;
}

std::vector<InspectedProperty> inspectWorld(GameData const& data, Json const& level) {
    std::vector<InspectedProperty> properties;
    auto const world = level.is_object() ? level.find("world") : level.end();
    for (PropertyInfo const* const info : propertiesAt(data, PropertyPlace::world)) {
        std::string const key(info->text.key);
        bool const stated = world != level.end() && world->is_object() && world->contains(key);
        auto fields = fieldsOf(data, level, *info, stated ? (*world)[key] : Json());
        if (!fields) {
            continue;
        }
        InspectedProperty property{key, std::string(info->text.name), std::string(info->text.meaning),
                                   PropertyPlace::world, stated ? ValueOrigin::own : ValueOrigin::part};
        property.canReset = property.canRemove = stated;
        property.marker = isMarker(*info);
        property.fields = std::move(*fields);
        properties.push_back(std::move(property));
    }
    return properties;
}

std::vector<InspectedField> inspectJoint(GameData const& data, Json const& level, std::size_t joint) {
    Json const* const list = findList(level, "joints");
    if (list == nullptr || joint >= list->size() || !(*list)[joint].is_object()) {
        return {};
    }
    Json fields = (*list)[joint];
    fields.erase("name");
    return fieldsOf(data, level, propertyNamed(data, "joint"), fields)
        .value_or(std::vector<InspectedField>{});
}

} // namespace trembler::edit
