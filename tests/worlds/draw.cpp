#include "tests/worlds/draw.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trembler::worlds {
namespace {

using Json = nlohmann::json;

constexpr double endless = std::numeric_limits<double>::max();
constexpr int lastFrame = 24; // inputs and changes come before it
constexpr int deepest = 6;    // conditions inside one another

} // namespace

Json const& Draw::resolved(Json const& schema) const {
    Json const* at = &schema;
    while (at->contains("$ref")) {
        at = &schema_.at(Json::json_pointer(at->at("$ref").get<std::string>().substr(1)));
    }
    return *at;
}

double Draw::ordinary(double low, double high) {
    double number = bySize(0.05, 20);
    if (low < 0 && chance(0.5)) {
        number = -number;
    }
    if (chance(0.15)) {
        number = std::round(number);
    }
    if (number >= low && number <= high) {
        return number;
    }
    // A range without an ordinary value: a value near its lower end.
    return std::clamp(low > 0 ? low * bySize(1, 100) : low, low, high);
}

double Draw::wild(double low, double high) {
    if (chance(0.3)) {
        return low + unit() * (high - low);
    }
    double const most = std::max(std::abs(low), std::abs(high));
    double const size = bySize(std::min(1e-9, most), most);
    double const sign = low < 0 && (high <= 0 || chance(0.5)) ? -1 : 1;
    return std::clamp(sign * size, low, high);
}

Json Draw::number(Json const& schema) {
    bool const whole = schema.value("type", "") == "integer";
    double const excluded = schema.value("exclusiveMinimum", -endless);
    double low = schema.value("minimum", excluded);
    double const high = schema.value("maximum", endless);
    if (low == excluded && excluded > -endless) {
        low = std::nextafter(excluded, endless);
    }
    if (low == -endless || high == endless) {
        double const free = whole ? 1 + static_cast<double>(below(lastFrame)) : ordinary(-50, 50);
        return whole ? Json(static_cast<std::int64_t>(std::max(free, low))) : Json(free);
    }
    std::size_t const index = numbers_++;
    double drawn = 0;
    if (spike) {
        drawn = spike->number == index ? (spike->high ? high : low) : ordinary(low, high);
    } else if (chance(manner_.extremes)) {
        std::vector<double> const ends{low, high, std::clamp(0.0, low, high), std::clamp(1e-300, low, high)};
        drawn = oneOf(ends);
    } else {
        drawn = chance(manner_.anywhere) ? wild(low, high) : ordinary(low, high);
    }
    if (whole) {
        return static_cast<std::int64_t>(std::clamp(std::round(drawn), std::ceil(low), std::floor(high)));
    }
    return drawn;
}

std::string Draw::name() {
    return objects.empty() || chance(0.01) ? std::string("world") : oneOf(objects);
}

Json Draw::text(std::string const& key) {
    if (key == "part") {
        return oneOf(parts_);
    }
    if (key == "network") {
        return chance(0.6) ? "" : "second";
    }
    if (key == "colour") {
        return "#3366cc";
    }
    return chance(0.5) ? "" : "some";
}

Json Draw::list(Json const& schema, std::string const& key) {
    std::size_t const least = schema.value("minItems", std::size_t{0});
    std::size_t const most = std::min(schema.value("maxItems", least + 3), least + 3);
    Json items = Json::array();
    std::size_t const count = least + below(most - least + 1);
    for (std::size_t i = 0; i < count; ++i) {
        items.push_back(value(schema.at("items"), key));
    }
    if (key == "cut" && items.size() == 2 && items[0] == items[1] && objects.size() > 1) {
        items[1] = items[0] == objects[0] ? objects[1] : objects[0];
    }
    return items;
}

Json Draw::place() {
    return Json::array({(2 * unit() - 1) * manner_.spread, (2 * unit() - 1) * manner_.spread});
}

Json Draw::shape() {
    Json const& items =
        schema_.at("$defs").at("properties").at("properties").at("shape").at("anyOf").at(0).at("items");
    Json pieces = Json::array();
    std::size_t const count = chance(0.75) ? 1 : 1 + below(4);
    for (std::size_t i = 0; i < count; ++i) {
        Json piece = object(items, 1);
        piece["angle_deg"] = chance(0.5) ? 0.0 : unit() * 360;
        piece["at"] =
            count == 1 && chance(0.9) ? Json::array({0, 0}) : Json::array({unit() - 0.5, unit() - 0.5});
        if (piece["form"] == "polygon") {
            Json corners = Json::array();
            std::size_t const corner = 3 + below(6);
            double const radius = piece["radius"].get<double>();
            for (std::size_t k = 0; k < corner; ++k) {
                double const angle =
                    6.283185307179586 * (static_cast<double>(k) + 0.3 * unit()) / static_cast<double>(corner);
                corners.push_back({std::clamp(radius * std::cos(angle), -1e3, 1e3),
                                   std::clamp(radius * std::sin(angle), -1e3, 1e3)});
            }
            piece["corners"] = std::move(corners);
        } else if (piece["form"] == "capsule" && chance(0.9)) {
            piece["width"] =
                std::min(1e4, std::max(piece["width"].get<double>(), 2 * piece["radius"].get<double>()));
        }
        // Each form with its own measures; others would be refused.
        Json const form = piece["form"];
        auto const drop = [&](char const* key, bool keep) {
            if (!keep) {
                piece.erase(key);
            }
        };
        drop("corners", form == "polygon");
        drop("radius", form == "circle" || form == "capsule");
        drop("width", form == "box" || form == "capsule");
        drop("height", form == "box");
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

Json Draw::joint(Json const& schema) {
    Json made = object(schema, 0.4);
    made.erase("name");
    made["a"] = name();
    made["at"] = place();
    bool const gear = made["form"] == "gear";
    if (!gear) {
        made.erase("joint_a");
        made.erase("joint_b");
    } else {
        if (couplings.size() < 2) {
            made["form"] = "spring";
        } else {
            made["joint_a"] = oneOf(couplings);
            made["joint_b"] = oneOf(couplings);
        }
    }
    if (made["form"] == "pulley" || chance(0.7)) {
        made["b"] = name();
    }
    for (char const* const key : {"at_b", "ground_a", "ground_b"}) {
        if (made.contains(key)) {
            made[key] = place();
        }
    }
    bool const springs = made["form"] == "spring" || made["form"] == "wheel";
    if (springs && !made.contains("stiffness")) {
        made["stiffness"] = bySize(1, 1e4);
    }
    if (made["form"] == "pulley") {
        made["ratio"] = bySize(0.1, 10);
    }
    return made;
}

Json Draw::object(Json const& schema, double share) {
    Json made = Json::object();
    Json const required = schema.value("required", Json::array());
    std::size_t const least = schema.value("minProperties", std::size_t{0});
    std::size_t const most = schema.value("maxProperties", std::size_t{1000});
    std::vector<std::string> optional;
    if (!schema.contains("properties")) {
        return made; // its members have any names, such as those of other objects
    }
    for (auto const& [key, member] : schema.at("properties").items()) {
        if (std::find(required.begin(), required.end(), key) != required.end()) {
            made[key] = value(member, key);
        } else {
            optional.push_back(key);
        }
    }
    for (std::string const& key : optional) {
        if (made.size() < most && chance(share)) {
            made[key] = value(schema.at("properties").at(key), key);
        }
    }
    while (made.size() < least && !optional.empty()) {
        std::string const& key = oneOf(optional);
        made[key] = value(schema.at("properties").at(key), key);
    }
    return made;
}

Json Draw::value(Json const& unresolved, std::string const& key) {
    std::string const reference = unresolved.value("$ref", "");
    if (reference.ends_with("/name")) {
        return name();
    }
    if (reference.ends_with("/point")) {
        return place();
    }
    Json const& schema = resolved(unresolved);
    if (schema.contains("const")) {
        return schema.at("const");
    }
    if (schema.contains("enum")) {
        return schema.at("enum").at(below(schema.at("enum").size()));
    }
    for (char const* const choice : {"anyOf", "oneOf"}) {
        if (schema.contains(choice)) {
            Json const& all = schema.at(choice);
            // Mostly the long form of values that also have a short one; simple conditions at great depth.
            bool const first = std::string(choice) == "anyOf" ? chance(0.9) : depth_ >= deepest;
            ++depth_;
            Json drawn = value(all.at(first ? 0 : below(all.size())), key);
            --depth_;
            return drawn;
        }
    }
    std::string const type = schema.value("type", "");
    if (type == "boolean") {
        return chance(0.5);
    }
    if (type == "number" || type == "integer") {
        return number(schema);
    }
    if (type == "string") {
        return text(key);
    }
    if (type == "array") {
        return key == "shape" ? shape() : list(schema, key);
    }
    return object(schema, 0.5);
}

} // namespace trembler::worlds
