#include "runtime/level/json/schema_pieces.hpp"

#include "runtime/level/json/text_limits.hpp"

#include <fmt/format.h>

#include <utility>

namespace trembler::json_schema {

using Json = nlohmann::ordered_json;

Json reference(std::string_view definition) {
    return Json{{"$ref", fmt::format("#/$defs/{}", definition)}};
}

Json text() {
    return Json{{"type", "string"}, {"maxLength", limits::text}};
}

Json listOf(Json items, std::size_t most) {
    return Json{{"type", "array"}, {"items", std::move(items)}, {"maxItems", most}};
}

Json strictObject(Json properties, std::vector<std::string> const& required) {
    Json schema{{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
    if (!required.empty()) {
        schema["required"] = required;
    }
    return schema;
}

} // namespace trembler::json_schema
