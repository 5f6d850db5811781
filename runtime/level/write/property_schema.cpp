#include "runtime/level/write/property_schema.hpp"

#include "runtime/level/json/schema_pieces.hpp"
#include "runtime/level/json/text_limits.hpp"
#include "runtime/level/property/field_outline.hpp"
#include "runtime/level/property/property_reader.hpp"

#include <fmt/format.h>

#include <limits>
#include <set>
#include <utility>

namespace trembler {
namespace {

using Json = nlohmann::ordered_json;

/// "minimum" and "maximum" of a field, in the unit of the file.
void addRange(Json& schema, FieldInfo const& info) {
    constexpr double all = std::numeric_limits<double>::max();
    auto const limit = [&](double value) { return isAngle(info.unit) ? degrees(value) : value; };
    if (info.minimum > -all) {
        schema[info.minimumExcluded ? "exclusiveMinimum" : "minimum"] = limit(info.minimum);
    }
    if (info.maximum < all) {
        schema["maximum"] = limit(info.maximum);
    }
}

/// Collects the schema of every field. If fields depend on a choice, it is run once for each of the choice's
/// values.
class SchemaVisitor final : public FieldVisitor {
public:
    Json properties = Json::object();
    std::set<std::string> required;
    /// The number of values of the first choice, and the value to set it to.
    std::size_t choices = 0;
    int pretended = -1;

    void boolean(FieldInfo const& info, bool&) override { put(info, {{"type", "boolean"}}); }
    void integer(FieldInfo const& info, std::int32_t&) override {
        Json schema{{"type", "integer"}};
        addRange(schema, limits(info));
        put(info, std::move(schema));
    }
    void number(FieldInfo const& info, double&) override {
        Json schema{{"type", "number"}};
        addRange(schema, limits(info));
        put(info, std::move(schema));
    }
    void vector(FieldInfo const& info, Vec2&) override {
        Json item{{"type", "number"}};
        addRange(item, limits(info));
        put(info, {{"type", "array"}, {"items", std::move(item)}, {"minItems", 2}, {"maxItems", 2}});
    }
    void text(FieldInfo const& info, std::string&) override {
        put(info, {{"type", "string"}, {"maxLength", trembler::limits::textInProperty}});
    }
    void object(FieldInfo const& info, ObjectId&) override { put(info, json_schema::reference("name")); }
    void choice(FieldInfo const& info, ChoiceField field) override {
        if (choices == 0) {
            choices = field.names.size();
            if (pretended >= 0) {
                field.index = pretended;
            }
        }
        Json names = Json::array();
        for (std::string_view const name : field.names) {
            names.push_back(name);
        }
        put(info, {{"enum", std::move(names)}});
    }
    void list(FieldInfo const& info, ListField& field) override {
        bool const hasFields = field.elementsHaveFields();
        SchemaVisitor const element = ofAllVariants([&](SchemaVisitor& visitor) {
            visitor.listInfo_ = hasFields ? nullptr : &info;
            field.resize(0);
            field.resize(1);
            field.visitElement(0, visitor);
        });
        field.resize(0);
        Json schema =
            json_schema::listOf(hasFields ? element.objectSchema() : element.properties["value"], info.most);
        if (info.least > 0) {
            schema["minItems"] = info.least;
        }
        put(info, std::move(schema));
    }
    /// All fields with any value of the first choice; a field is required if it is required with every value.
    /// visit(v) lets v visit an initial value.
    template <class Visit>
    [[nodiscard]] static SchemaVisitor ofAllVariants(Visit&& visit) {
        SchemaVisitor all;
        visit(all);
        for (int i = 0; i < static_cast<int>(all.choices); ++i) {
            SchemaVisitor variant;
            variant.pretended = i;
            visit(variant);
            for (auto const& [key, schema] : variant.properties.items()) {
                if (!all.properties.contains(key)) {
                    all.properties[key] = schema;
                }
            }
            std::erase_if(all.required,
                          [&](std::string const& key) { return !variant.required.contains(key); });
        }
        return all;
    }
    [[nodiscard]] Json objectSchema() const {
        Json schema{{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
        if (!required.empty()) {
            schema["required"] = required;
        }
        return schema;
    }

private:
    [[nodiscard]] FieldInfo const& limits(FieldInfo const& info) const {
        return listInfo_ == nullptr ? info : *listInfo_;
    }
    void put(FieldInfo const& info, Json schema) {
        std::string const key(info.key);
        if (listInfo_ == nullptr) {
            schema["description"] = describedField(info);
        }
        properties[key] = std::move(schema);
        if (info.required) {
            required.insert(key);
        }
    }

    FieldInfo const* listInfo_ = nullptr;
};

/// All fields that a property can have.
SchemaVisitor fieldsOf(PropertyInfo const& info) {
    return SchemaVisitor::ofAllVariants([&](SchemaVisitor& visitor) { info.makeValue()->visit(visitor); });
}

Json withoutDescription(Json schema) {
    schema.erase("description");
    return schema;
}

} // namespace

std::string describedField(FieldInfo const& info) {
    std::string_view const unit = info.unit == "rad"     ? "degrees"
                                  : info.unit == "rad/s" ? "degrees/s"
                                                         : info.unit;
    return unit.empty() ? std::string(info.meaning) : fmt::format("{} ({})", info.meaning, unit);
}

Json propertySchema(PropertyInfo const& info) {
    auto const value = info.makeValue();
    auto const outline = outlineOf(*value);
    SchemaVisitor const fields = fieldsOf(info);
    Json schema;
    if (outline.empty()) {
        schema = Json{{"type", "boolean"}};
    } else if (isBare(outline)) {
        schema = withoutDescription(fields.properties["value"]);
        if (outline.front().type != FieldType::boolean) {
            schema = Json{{"anyOf", Json::array({std::move(schema), Json{{"const", false}}})}};
        }
    } else {
        Json shortForm = fields.required.empty() ? Json{{"type", "boolean"}} : Json{{"const", false}};
        schema = Json{{"anyOf", Json::array({fields.objectSchema(), std::move(shortForm)})}};
    }
    std::string text(info.text.meaning);
    if (!outline.empty() && isBare(outline)) {
        text += " Value: " + describedField(outline.front().info) + ".";
    }
    schema["description"] = text;
    return schema;
}

Json fieldsSchema(PropertyInfo const& info) {
    return fieldsOf(info).objectSchema();
}

Json propertiesSchema(Registry const& registry, PropertyPlace place) {
    Json members = Json::object();
    for (PropertyInfo const* info : registry.objectProperties()) {
        if (info->text.place == place && info->text.key != "name") {
            members[std::string(info->text.key)] = propertySchema(*info);
        }
    }
    return Json{{"type", "object"}, {"properties", std::move(members)}, {"additionalProperties", false}};
}

} // namespace trembler
