#include "runtime/level/write/change_schema.hpp"

#include "runtime/level/json/schema_pieces.hpp"
#include "runtime/level/model/detail_levels.hpp"
#include "runtime/level/model/recorded_change.hpp"
#include "runtime/level/property/field_outline.hpp"
#include "runtime/level/write/property_schema.hpp"

#include <map>
#include <utility>

namespace trembler {
namespace {

using Json = nlohmann::ordered_json;

/// The schema of the periods of components that may miss frames.
Json periodsSchema(Registry const& registry) {
    Json periods = Json::object();
    for (Registration const& registration : registry.components()) {
        if (registration.longestPeriod > registration.period) {
            periods[title(*registration.info)] =
                Json{{"type", "integer"}, {"minimum", 1}, {"maximum", registration.longestPeriod}};
        }
    }
    return json_schema::strictObject(std::move(periods));
}

/// The schema of a number of the world within its AccuracyRange.
Json settingSchema(FieldOutline const& field) {
    Json schema{{"type", field.type == FieldType::integer ? "integer" : "number"},
                {"minimum", field.info.accuracy.from},
                {"maximum", field.info.accuracy.to}};
    if (field.type == FieldType::integer) {
        schema["minimum"] = static_cast<std::int64_t>(field.info.accuracy.from);
        schema["maximum"] = static_cast<std::int64_t>(field.info.accuracy.to);
    }
    if (field.info.accuracy.orAutomatic) {
        schema = Json{{"anyOf", Json::array({Json{{"const", 0}}, std::move(schema)})}};
    }
    schema["description"] = describedField(field.info);
    return schema;
}

Json settingsSchema(Registry const& registry) {
    Json settings = Json::object();
    for (PropertyInfo const* info : registry.objectProperties()) {
        if (info->text.place != PropertyPlace::world) {
            continue;
        }
        Json numbers = Json::object();
        for (FieldOutline const& field : outlineOf(*info->makeValue())) {
            if (isAccuracySetting(field)) {
                numbers[std::string(field.info.key)] = settingSchema(field);
            }
        }
        if (!numbers.empty()) {
            settings[std::string(info->text.key)] = json_schema::strictObject(std::move(numbers));
        }
    }
    return json_schema::strictObject(std::move(settings));
}

} // namespace

Json detailSchema(Registry const& registry, bool orNothing) {
    Json detail = Json::object();
    for (auto const& [effect, levels] : detailLevels(registry)) {
        detail[effect] = Json{{"enum", levels}};
        if (orNothing) {
            detail[effect]["enum"].push_back("");
        }
    }
    return json_schema::strictObject(std::move(detail));
}

Json changeSchema(Registry const& registry) {
    Json const frame{{"type", "integer"},
                     {"minimum", 1},
                     {"description", "the first frame in which the change applies, from 1"}};
    std::map<std::string_view, Json> bodies{{"detail", detailSchema(registry, true)},
                                            {"period", periodsSchema(registry)},
                                            {"setting", settingsSchema(registry)}};
    Json kinds = Json::array();
    for (std::string_view const kind : recordedChangeNames) {
        Json body = std::move(bodies.at(kind));
        body["minProperties"] = 1;
        Json members{{"frame", frame}};
        members[std::string(kind)] = std::move(body);
        kinds.push_back(json_schema::strictObject(std::move(members), {"frame", std::string(kind)}));
    }
    return Json{
        {"description",
         "A change of the accuracy with which the level is computed from a frame on, never of its physics. A "
         "detail level must be able to compute everything that the level states; see docs/budget.md."},
        {"oneOf", std::move(kinds)}};
}

} // namespace trembler
