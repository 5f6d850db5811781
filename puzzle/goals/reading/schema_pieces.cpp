#include "puzzle/goals/reading/schema_pieces.hpp"

#include <utility>

namespace trembler::goal_schema {

using Json = nlohmann::ordered_json;

Json selector() {
    return reference("selector");
}

Json condition() {
    return reference("condition");
}

Json listOf(Json items, std::size_t most) {
    return Json{{"type", "array"}, {"items", std::move(items)}, {"minItems", 1}, {"maxItems", most}};
}

} // namespace trembler::goal_schema
