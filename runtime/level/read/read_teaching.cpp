#include "runtime/level/read/read_teaching.hpp"

#include "runtime/level/json/limits.hpp"
#include "runtime/level/json/schema_pieces.hpp"
#include "runtime/level/property/field_outline.hpp"
#include "runtime/level/read/read_area.hpp"

#include <array>
#include <optional>
#include <string_view>

namespace trembler {
namespace {

using Taught = TeachingStep::Kind;

constexpr std::size_t mostSteps = 20;
constexpr double mostTeachingDegrees = 360;

/// In the order of TeachingStep::Kind.
constexpr std::array<std::string_view, 5> stepKeys{"place", "wire", "run", "grab", "cut"};

/// The two ends of a wire.
bool readTaughtEnds(JsonNode const& body, TeachingStep& step) {
    if (!body.value().is_array() || body.size() != 2) {
        body.complainOfType("a list of the two objects that the wire connects");
        return false;
    }
    step.object = body.element(0).name("the name of an object").value_or("");
    step.other = body.element(1).name("the name of an object").value_or("");
    return !step.object.empty() && !step.other.empty();
}

bool readTaughtPlace(MemberReader& reader, char const* key, Vec2& to) {
    auto const node = reader.required(key, "a list [x, y] of two numbers, in m");
    auto const place = node ? node->vector(-farthestPlace, farthestPlace) : std::nullopt;
    to = place.value_or(Vec2{});
    return place.has_value();
}

bool readTaught(MemberReader& reader, JsonNode const& body, TeachingStep& step) {
    switch (step.kind) {
    case Taught::place: {
        auto const part = body.name("the name of a part in the toolbox");
        step.object = part.value_or("");
        if (auto const angle = reader.optional("angle_deg")) {
            step.angle = radians(angle->number(-mostTeachingDegrees, mostTeachingDegrees).value_or(0));
        }
        if (auto const flipped = reader.optional("flipped")) {
            step.flipped = flipped->boolean().value_or(false);
        }
        return readTaughtPlace(reader, "at", step.at) && part;
    }
    case Taught::run:
        if (body.value() != true) {
            body.complainOfType("true");
            return false;
        }
        return true;
    case Taught::grab: {
        auto const object = body.name("the name of an object");
        step.object = object.value_or("");
        return readTaughtPlace(reader, "to", step.at) && object;
    }
    case Taught::wire:
    case Taught::cut:
        return readTaughtEnds(body, step);
    }
    return false;
}

std::optional<TeachingStep> readTeachingStep(JsonNode const& node) {
    MemberReader reader(node, "an object like {\"place\": PART, \"at\"} or {\"run\": true}");
    if (!reader.valid()) {
        return std::nullopt;
    }
    TeachingStep step;
    step.path = node.path();
    std::optional<JsonNode> body;
    int kinds = 0;
    for (std::size_t kind = 0; kind < stepKeys.size(); ++kind) {
        if (auto const found = reader.optional(std::string(stepKeys[kind]))) {
            body = found;
            step.kind = static_cast<Taught>(kind);
            ++kinds;
        }
    }
    bool good = kinds == 1;
    if (!good) {
        node.complain(kinds == 0 ? "states nothing to do" : "states several things to do at once",
                      "one of \"place\" (with \"at\"), \"wire\", \"run\", \"grab\" (with \"to\"), \"cut\"");
        for (char const* const key : {"at", "to", "angle_deg", "flipped"}) {
            reader.know(key);
        }
    }
    good = good && readTaught(reader, *body, step);
    reader.finish();
    return good ? std::optional(step) : std::nullopt;
}

} // namespace

std::vector<TeachingStep> readTeaching(JsonNode const& node) {
    std::vector<TeachingStep> steps;
    if (!node.isList("a list of steps", mostSteps)) {
        return steps;
    }
    for (std::size_t i = 0; i < node.size(); ++i) {
        if (auto step = readTeachingStep(node.element(i))) {
            steps.push_back(std::move(*step));
        }
    }
    return steps;
}

nlohmann::ordered_json writeTeaching(std::vector<TeachingStep> const& steps) {
    using Json = nlohmann::ordered_json;
    Json all = Json::array();
    for (TeachingStep const& step : steps) {
        std::string const key(stepKeys[static_cast<std::size_t>(step.kind)]);
        Json out;
        switch (step.kind) {
        case Taught::place:
            out[key] = step.object;
            out["at"] = {step.at.x, step.at.y};
            if (step.angle != 0) {
                out["angle_deg"] = degrees(step.angle);
            }
            if (step.flipped) {
                out["flipped"] = true;
            }
            break;
        case Taught::run:
            out[key] = true;
            break;
        case Taught::grab:
            out[key] = step.object;
            out["to"] = {step.at.x, step.at.y};
            break;
        case Taught::wire:
        case Taught::cut:
            out[key] = {step.object, step.other};
            break;
        }
        all.push_back(std::move(out));
    }
    return all;
}

nlohmann::ordered_json teachingSchema() {
    using Json = nlohmann::ordered_json;
    Json const name = json_schema::reference("name");
    Json const point = json_schema::reference("point");
    Json ends = json_schema::listOf(name, 2);
    ends["minItems"] = 2;
    Json const angle{{"type", "number"}, {"minimum", -mostTeachingDegrees}, {"maximum", mostTeachingDegrees}};
    Json steps = json_schema::listOf(
        Json{
            {"anyOf", Json::array({json_schema::strictObject({{"place", name},
                                                              {"at", point},
                                                              {"angle_deg", angle},
                                                              {"flipped", {{"type", "boolean"}}}},
                                                             {"place", "at"}),
                                   json_schema::strictObject({{"wire", ends}}, {"wire"}),
                                   json_schema::strictObject({{"run", {{"const", true}}}}, {"run"}),
                                   json_schema::strictObject({{"grab", name}, {"to", point}}, {"grab", "to"}),
                                   json_schema::strictObject({{"cut", ends}}, {"cut"})})}},
        mostSteps);
    steps["description"] =
        "What a beginner is shown to do, in this order, until it has been done. It does not "
        "influence the simulation.";
    return steps;
}

} // namespace trembler
