#include "puzzle/edit/inspect/inspector.hpp"

#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/inspect/field_list.hpp"
#include "puzzle/edit/tree/object_values.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "runtime/level/property/property_writer.hpp"

#include <algorithm>
#include <utility>

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

/// Marks the fields of a property in which the first object and another one differ.
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

/// The owners of the shown properties: objects, or a piece of each.
struct Owners {
    std::vector<Json const*> entries;
    std::string piece; ///< empty: the objects
};

/// One property of its owners; nothing if none of them has or removes it.
std::optional<InspectedProperty> inspectProperty(GameData const& data, PartStatements& parts,
                                                 Json const& level, Owners const& owners,
                                                 PropertyInfo const& info) {
    std::optional<InspectedProperty> found;
    bool onAll = true;
    bool first = true;
    bool const placement = info.text.place == PropertyPlace::placement;
    for (Json const* const entry : owners.entries) {
        Json const* const own = ownStatement(*entry, info, owners.piece);
        bool const fromPart = !parts.of(textOf(*entry, "part"), owners.piece, info).is_null();
        Json value = effectiveStatement(parts, *entry, info, owners.piece);
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

/// The pieces of an object's part, each under the name by which its entry states it, and others that the
/// entry states.
std::vector<InspectedPiece> piecesOfEntry(PartStatements& parts, Json const& entry) {
    std::string const part = textOf(entry, "part");
    std::vector<InspectedPiece> pieces;
    for (PartPiece const& piece : parts.pieces(part)) {
        pieces.push_back({piece.name, piece.main, false});
    }
    auto const stated = entry.is_object() ? entry.find("pieces") : entry.end();
    if (stated == entry.end() || !stated->is_object()) {
        return pieces;
    }
    for (auto const& item : stated->items()) {
        std::string const means = parts.pieceNamed(part, item.key());
        auto const known = std::find_if(pieces.begin(), pieces.end(),
                                        [&](InspectedPiece const& piece) { return piece.name == means; });
        if (known == pieces.end()) {
            pieces.push_back({item.key(), false, true});
        } else {
            known->name = item.key();
            known->stated = true;
        }
    }
    return pieces;
}

} // namespace

std::vector<InspectedProperty> inspectObjects(GameData const& data, Json const& level,
                                              std::vector<std::string> const& names,
                                              std::string const& piece) {
    std::vector<InspectedProperty> properties;
    Owners const owners{entriesNamed(level, names), piece};
    if (owners.entries.empty()) {
        return properties;
    }
    PartStatements parts(data);
    for (PropertyPlace const place : {PropertyPlace::placement, PropertyPlace::properties}) {
        if (place == PropertyPlace::placement && !piece.empty()) {
            continue; // a piece lies where its part says
        }
        for (PropertyInfo const* const info : propertiesAt(data, place)) {
            if (auto property = inspectProperty(data, parts, level, owners, *info)) {
                properties.push_back(std::move(*property));
            }
        }
    }
    return properties;
}

std::vector<AddableProperty> addableProperties(GameData const& data, Json const& level,
                                               std::vector<std::string> const& names,
                                               std::string const& piece) {
    std::vector<AddableProperty> addable;
    auto const entries = entriesNamed(level, names);
    PartStatements parts(data);
    for (PropertyInfo const* const info : propertiesAt(data, PropertyPlace::properties)) {
        bool const missing = std::any_of(entries.begin(), entries.end(), [&](Json const* entry) {
            return effectiveStatement(parts, *entry, *info, piece).is_null();
        });
        if (missing) {
            addable.push_back(
                {std::string(info->text.key), std::string(info->text.name), std::string(info->text.meaning)});
        }
    }
    return addable;
}

std::vector<InspectedPiece> inspectPieces(GameData const& data, Json const& level,
                                          std::vector<std::string> const& names) {
    std::vector<InspectedPiece> common;
    PartStatements parts(data);
    bool first = true;
    for (Json const* const entry : entriesNamed(level, names)) {
        std::vector<InspectedPiece> const here = piecesOfEntry(parts, *entry);
        if (std::exchange(first, false)) {
            common = here;
            continue;
        }
        std::vector<InspectedPiece> both;
        for (InspectedPiece const& piece : common) {
            auto const other = std::find_if(
                here.begin(), here.end(), [&](InspectedPiece const& one) { return one.name == piece.name; });
            if (other != here.end()) {
                both.push_back({piece.name, piece.main && other->main, piece.stated || other->stated});
            }
        }
        common = std::move(both);
    }
    return common;
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
