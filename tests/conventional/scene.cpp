#include "tests/conventional/scene.hpp"

#include <algorithm>

namespace trembler::conventional {

std::vector<std::unique_ptr<Scene>> allScenes() {
    std::vector<std::unique_ptr<Scene>> all;
    all.push_back(magnetScene());
    all.push_back(doorbellScene());
    all.push_back(doorScene());
    all.push_back(gateScene());
    return all;
}

std::vector<std::string> const& barParts() {
    static std::vector<std::string> const parts{"spanner", "steel bar", "copper bar", "wooden bar"};
    return parts;
}

Setting perturbed(Scene const& scene, Stage const& stage, std::uint64_t number) {
    Setting setting = scene.asDescribed(stage);
    auto const perturbations = scene.perturbations();
    Random random(0x7ec1b1e5ULL + 7919 * number);
    std::size_t const first = random.below(perturbations.size());
    perturbations[first].apply(setting, random);
    setting.kinds.push_back(perturbations[first].kind);
    if (random.chance(0.5)) {
        std::size_t const second =
            (first + 1 + random.below(perturbations.size() - 1)) % perturbations.size();
        perturbations[second].apply(setting, random);
        setting.kinds.push_back(perturbations[second].kind);
    }
    return setting;
}

nlohmann::json* find(Setting& setting, std::string const& name) {
    for (auto& object : setting.level.at("objects")) {
        if (object.at("name") == name) {
            return &object;
        }
    }
    return nullptr;
}

void shift(Setting& setting, std::string const& name, double x, double y, double degrees) {
    if (nlohmann::json* const object = find(setting, name)) {
        auto& at = object->at("at");
        at = {at[0].get<double>() + x, at[1].get<double>() + y};
        (*object)["angle_deg"] = object->value("angle_deg", 0.0) + degrees;
    }
}

void removeWires(Setting& setting, std::string const& name) {
    auto& wires = setting.level.at("connections");
    wires.erase(
        std::remove_if(wires.begin(), wires.end(),
                       [&](nlohmann::json const& wire) { return wire[0] == name || wire[1] == name; }),
        wires.end());
    std::erase_if(setting.cuts, [&](Setting::Cut const& cut) { return cut.a == name || cut.b == name; });
}

void takeAway(Setting& setting, std::string const& name) {
    auto& objects = setting.level.at("objects");
    objects.erase(std::remove_if(objects.begin(), objects.end(),
                                 [&](nlohmann::json const& object) { return object.at("name") == name; }),
                  objects.end());
    removeWires(setting, name);
    auto& inputs = setting.inputs;
    bool holds = false; // a move belongs to the grab before it
    nlohmann::json kept = nlohmann::json::array();
    for (nlohmann::json const& input : inputs) {
        if (input.contains("grab")) {
            holds = input.at("grab") == name;
        }
        bool const about = (input.contains("grab") && input.at("grab") == name) ||
                           (input.contains("remove") && input.at("remove") == name) ||
                           (input.contains("move") && holds);
        if (!about) {
            kept.push_back(input);
        }
    }
    inputs = kept;
}

void add(Setting& setting, std::string const& name, std::string const& part, Vec2 at, double degrees,
         nlohmann::json properties) {
    if (find(setting, name) != nullptr) {
        return;
    }
    nlohmann::json object = {{"name", name}, {"at", {at.x, at.y}}, {"angle_deg", degrees}};
    if (!part.empty()) {
        object["part"] = part;
    }
    if (!properties.empty()) {
        object["properties"] = std::move(properties);
    }
    setting.level.at("objects").push_back(std::move(object));
}

void lift(Setting& setting, std::string const& name, Vec2 at, int frame) {
    if (find(setting, name) == nullptr || !setting.inputs.empty()) {
        return;
    }
    setting.inputs.push_back({{"frame", frame}, {"grab", name}, {"at", {at.x, at.y}}});
    int step = 0;
    for (double const height : {0.1, 0.3, 0.6, 0.9, 1.2}) {
        setting.inputs.push_back({{"frame", frame + 1 + 8 * step++}, {"move", {at.x, at.y + height}}});
    }
}

void cutAny(Setting& setting, Random& random, int first, int last) {
    auto const& wires = setting.level.at("connections");
    if (wires.empty() || !setting.cuts.empty()) {
        return;
    }
    auto const& wire = wires.at(random.below(wires.size()));
    setting.cuts.push_back(
        {static_cast<std::uint64_t>(first) + random.below(static_cast<std::size_t>(last - first + 1)),
         wire[0], wire[1]});
}

std::vector<std::string> objectNames(Setting const& setting) {
    std::vector<std::string> names;
    for (auto const& object : setting.level.at("objects")) {
        names.push_back(object.at("name"));
    }
    return names;
}

double stated(Setting const& setting, std::string const& name, std::string const& property,
              std::string const& field, double otherwise) {
    for (auto const& object : setting.level.at("objects")) {
        if (object.at("name") == name && object.contains("properties") &&
            object.at("properties").contains(property)) {
            auto const& value = object.at("properties").at(property);
            if (value.is_object()) {
                return value.value(field, otherwise);
            }
            return value.is_number() ? value.get<double>() : otherwise;
        }
    }
    return otherwise;
}

bool isMarkedConducting(Game const& game, std::string const& name) {
    static std::set<std::string> const prefabs{"switch lever", "spanner",     "steel bar",
                                               "copper bar",   "copper clip", "battery +"};
    return prefabs.contains(game.prefab(name));
}

ScriptSet onEveryCut(Setting const& setting, std::string const& flag) {
    ScriptSet scripts;
    for (auto const& wire : setting.level.at("connections")) {
        std::string const a = wire[0];
        std::string const b = wire[1];
        scripts.push_back({.on = EventScript::On::wireCut,
                           .object = a,
                           .other = b,
                           .run = [flag](Game& game, std::string const&) { game.flags[flag] = 1; }});
    }
    return scripts;
}

} // namespace trembler::conventional
