#include "puzzle/edit/tree/object_values.hpp"

#include "puzzle/edit/tree/tree_access.hpp"
#include "runtime/level/property/field_outline.hpp"
#include "runtime/level/property/property_reader.hpp"
#include "runtime/level/property/property_writer.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler::edit {

std::unique_ptr<PropertyValue> readValue(PropertyInfo const& info, Json const& json, NameTable& names,
                                         std::string* why) {
    try {
        auto const document =
            JsonDocument::parse(json.dump(-1, ' ', false, Json::error_handler_t::replace), "value");
        Problems problems;
        auto value = readProperty(info, JsonNode(*document, document->root(), "", problems), &names);
        problems.throwIfAny();
        return value;
    } catch (InputError const& error) {
        if (why != nullptr) {
            Diagnostic const& first = error.diagnostics().front();
            std::string const at = first.path.empty() ? "" : first.path.substr(1) + " ";
            *why = at + first.message + (first.expected.empty() ? "" : "; expected " + first.expected);
        }
        return nullptr;
    }
}

Json const* ownStatement(Json const& entry, PropertyInfo const& info, std::string const& piece) {
    Json const* around = &entry;
    auto const enter = [&around](std::string const& key) {
        if (around == nullptr || !around->is_object()) {
            around = nullptr;
            return;
        }
        auto const found = around->find(key);
        around = found == around->end() ? nullptr : &*found;
    };
    if (!piece.empty()) {
        if (info.text.place != PropertyPlace::properties) {
            return nullptr;
        }
        enter("pieces");
        enter(piece);
    } else if (info.text.place == PropertyPlace::properties) {
        enter("properties");
    }
    enter(std::string(info.text.key));
    return around;
}

Json partStatement(GameData const& data, Json const& entry, PropertyInfo const& info) {
    PartDefinition const* const part = data.parts.find(textOf(entry, "part"));
    PropertyValue const* const value = part == nullptr ? nullptr : part->properties.find(info);
    return value == nullptr ? Json() : writeProperty(*value);
}

Json effectiveStatement(GameData const& data, Json const& entry, PropertyInfo const& info) {
    if (Json const* const own = ownStatement(entry, info)) {
        return *own == false && falseRemoves(info) ? Json() : *own;
    }
    return partStatement(data, entry, info);
}

Json effectiveStatement(PartStatements& parts, Json const& entry, PropertyInfo const& info,
                        std::string const& piece) {
    std::string const part = textOf(entry, "part");
    Json const* own = ownStatement(entry, info, piece);
    if (own == nullptr && !piece.empty()) {
        std::vector<PartPiece> const& all = parts.pieces(part);
        std::string const meant = parts.pieceNamed(part, piece);
        bool const main = std::any_of(all.begin(), all.end(),
                                      [&](PartPiece const& one) { return one.main && one.name == meant; });
        own = main ? ownStatement(entry, info) : nullptr;
    }
    if (own != nullptr) {
        return *own == false && falseRemoves(info) ? Json() : *own;
    }
    return parts.of(part, piece, info);
}

bool falseRemoves(PropertyInfo const& info) {
    auto const value = info.makeValue();
    auto const fields = outlineOf(*value);
    return !isBare(fields) || fields.front().type != FieldType::boolean;
}

std::optional<Shape> shapeOf(GameData const& data, Json const& entry) {
    PropertyInfo const& info = propertyInfo<Shape>();
    if (Json const* const own = ownStatement(entry, info)) {
        NameTable names;
        auto const value = readValue(info, *own, names);
        return value ? std::optional(static_cast<ValueOf<Shape> const&>(*value).value) : std::nullopt;
    }
    PartDefinition const* const part = data.parts.find(textOf(entry, "part"));
    Shape const* const shape = part == nullptr ? nullptr : part->properties.find<Shape>();
    return shape == nullptr ? std::nullopt : std::optional(*shape);
}

void setStatement(Json& entry, PropertyInfo const& info, Json value, std::string const& piece) {
    std::string const key(info.text.key);
    if (info.text.place == PropertyPlace::placement) {
        if (!piece.empty()) {
            throw CommandError("a piece lies where its part says");
        }
        if (value.is_null()) {
            entry.erase(key);
        } else {
            setObjectMember(entry, key, std::move(value));
        }
        return;
    }
    char const* const around = piece.empty() ? "properties" : "pieces";
    if (!entry.contains(around)) {
        if (value.is_null()) {
            return;
        }
        setObjectMember(entry, around, Json::object());
    }
    Json& stated = entry[around];
    bool const other =
        !piece.empty() && stated.is_object() && stated.contains(piece) && !stated[piece].is_object();
    if (!stated.is_object() || other) {
        throw CommandError("the properties of an object are no object");
    }
    if (!value.is_null()) {
        (piece.empty() ? stated : stated[piece])[key] = std::move(value);
        return;
    }
    if (piece.empty()) {
        stated.erase(key);
    } else if (stated.contains(piece)) {
        stated[piece].erase(key);
        dropIfEmpty(stated, piece.c_str());
    }
    dropIfEmpty(entry, around);
}

PropertyInfo const& propertyNamed(GameData const& data, std::string const& key) {
    PropertyInfo const* const info = data.registry.objectProperty(key);
    if (info == nullptr || info->text.place == PropertyPlace::hidden) {
        throw CommandError(fmt::format("there is no property '{}'", key));
    }
    return *info;
}

} // namespace trembler::edit
