#include "puzzle/goals/reading/condition_outline.hpp"

#include "puzzle/goals/conditions/table.hpp"
#include "puzzle/goals/reading/schema_pieces.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace trembler {
namespace {

using Json = nlohmann::ordered_json;

ConditionOutline outlineOf(ConditionKind const& kind) {
    ConditionOutline outline{.key = std::string(kind.key()), .schema = kind.schema()};
    if (isCondition(outline.schema)) {
        outline.inner = InnerConditions::value;
    } else if (outline.schema.contains("items") && isCondition(outline.schema["items"])) {
        outline.inner = InnerConditions::list;
    } else if (outline.schema.contains("properties")) {
        for (auto const& member : outline.schema["properties"].items()) {
            if (isCondition(member.value())) {
                outline.inner = InnerConditions::member;
                outline.member = member.key();
            }
        }
    }
    return outline;
}

void forSelectorsIn(Json& value, Json const& schema, std::function<void(Json&)> const& visit) {
    if (isSelector(schema)) {
        visit(value);
    } else if (isCondition(schema)) {
        forSelectors(value, visit);
    } else if (schema.contains("items") && value.is_array()) {
        for (Json& element : value) {
            forSelectorsIn(element, schema["items"], visit);
        }
    } else if (schema.contains("properties") && value.is_object()) {
        Json const& members = schema["properties"];
        for (auto const& member : value.items()) {
            if (auto const known = members.find(member.key()); known != members.end()) {
                forSelectorsIn(member.value(), *known, visit);
            }
        }
    }
}

} // namespace

std::span<ConditionOutline const> conditionOutlines() {
    static std::vector<ConditionOutline> const all = [] {
        std::vector<ConditionOutline> made;
        for (ConditionKind const* const kind : conditionKinds()) {
            made.push_back(outlineOf(*kind));
        }
        return made;
    }();
    return all;
}

ConditionOutline const* findOutline(std::string_view key) {
    std::span<ConditionOutline const> const all = conditionOutlines();
    auto const found =
        std::find_if(all.begin(), all.end(), [&](ConditionOutline const& one) { return one.key == key; });
    return found == all.end() ? nullptr : &*found;
}

bool isSelector(Json const& schema) {
    return schema == goal_schema::selector();
}

bool isArea(Json const& schema) {
    return schema == goal_schema::reference("area");
}

bool isCondition(Json const& schema) {
    return schema == goal_schema::condition();
}

void forSelectors(Json& condition, std::function<void(Json&)> const& visit) {
    if (!condition.is_object()) {
        return;
    }
    for (auto const& item : condition.items()) {
        if (ConditionOutline const* const outline = findOutline(item.key())) {
            forSelectorsIn(item.value(), outline->schema, visit);
        }
    }
}

std::string conditionAround(Json const& goals, std::string const& place) {
    std::string around; // a condition
    Json::json_pointer const whole(place);
    std::vector<std::string> tokens;
    for (Json::json_pointer rest = whole; !rest.empty(); rest.pop_back()) {
        tokens.insert(tokens.begin(), rest.back());
    }
    for (std::size_t i = 0; i < tokens.size();) {
        ConditionOutline const* const outline = findOutline(tokens[i]);
        bool const nested = outline != nullptr && outline->inner != InnerConditions::none;
        std::size_t const steps = nested && outline->inner != InnerConditions::value ? 2 : 1;
        if (!nested || i + steps > tokens.size() ||
            (outline->inner == InnerConditions::member && tokens[i + 1] != outline->member)) {
            break;
        }
        Json::json_pointer inner(around);
        for (std::size_t step = 0; step < steps; ++step) {
            inner.push_back(tokens[i + step]);
        }
        if (!goals.contains(inner) || !goals[inner].is_object()) {
            break;
        }
        around = inner.to_string();
        i += steps;
    }
    return around;
}

} // namespace trembler
