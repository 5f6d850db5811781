#include "puzzle/goals/reading/schema_pieces.hpp"

#include <fmt/format.h>

#include <utility>

namespace trembler::goal_schema {

using Json = nlohmann::ordered_json;

Json reference(std::string_view name) {
    return Json{{"$ref", fmt::format("#/$defs/{}", name)}};
}

Json selector() {
    return reference("selector");
}

Json condition() {
    return reference("condition");
}

Json strictObject(Json properties, std::vector<std::string> const& required) {
    return Json{{"type", "object"},
                {"properties", std::move(properties)},
                {"additionalProperties", false},
                {"required", required}};
}

Json listOf(Json items, std::size_t most) {
    return Json{{"type", "array"}, {"items", std::move(items)}, {"minItems", 1}, {"maxItems", most}};
}

} // namespace trembler::goal_schema
