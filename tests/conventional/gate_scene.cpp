// The gate of section 3.1: a damaged wire, machinery that opens the gate, and an alarm on the same generator.
#include "tests/conventional/scene.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::conventional {
namespace gate_scene { // other scenes have functions of these names, too
namespace {

constexpr double raisedBy = 0.9; // m
constexpr double ratio = 2;      // rad of the wheel per m of the gate
constexpr double hoist = 300;    // N: 150 N m at that ratio

std::string described(bool free, bool alarm) {
    return std::string(free ? "the way is free" : "the way is barred") + (alarm ? ", alarm" : ", no alarm");
}

bool wayIsFree(Statement const& statement, Film const& bodies) {
    if (!bodies.joints.contains("rail")) {
        return true; // rammed: the motion of rigid bodies is not tested
    }
    Fact const& gate = statement.facts().at("gate");
    Fact const& wheel = statement.facts().at("wheel");
    std::uint64_t const end = statement.frames();
    bool const strong = wheel.motorTorque * ratio > 9.81 * gate.mass;
    if (!strong || !statement.inCircuit("wheel", end)) {
        return false;
    }
    for (double height = 0; height < raisedBy; height += 0.02) {
        Statement::Moved moved;
        moved["gate"] = {gate.start.at + Vec2{0, height}, 0, true};
        for (auto const& [name, fact] : statement.facts()) {
            bool const aside = name == "gate" || name == "wheel" || name == "floor";
            if (!aside && statement.touching("gate", name, end, moved)) {
                return false;
            }
        }
    }
    return true;
}

// ---- The conventional scripts

EventScript machinery(double force) {
    return {EventScript::On::update, "", "", [force](Game& game, std::string const&) {
                bool const on = game.flags["power"] > 0 && !(game.flags["dead"] > 0);
                if (on && game.velocity("gate").y < 1) {
                    game.push("gate", {0, force});
                }
                game.light("alarm", on);
            }};
}

ScriptSet asSpecified(Setting const&) {
    return {{EventScript::On::collision, "patch", "",
             [](Game& game, std::string const&) {
                 if (game.touching("patch", "object 1") && game.touching("patch", "object 2")) {
                     game.flags["power"] = 1;
                 }
             }},
            machinery(hoist)};
}

// The alternatives of 3.1: another metal object, a portable generator. (The truck needs rigid bodies only.)
ScriptSet withAlternatives(Setting const& setting) {
    auto const check = [](Game& game, std::string const&) {
        game.flags["power"] = 0;
        for (std::string const& bar : game.touched("object 2")) {
            bool const patches = isMarkedConducting(game, bar) && game.touching(bar, "object 1");
            if (patches || game.prefab(bar) == "battery +") {
                game.flags["power"] = 1;
            }
        }
    };
    ScriptSet scripts;
    for (auto const& wire : setting.level.at("connections")) {
        if (wire[0] == "generator" || (wire[0] == "object 2" && wire[1] == "wheel")) {
            scripts.push_back({EventScript::On::wireCut, wire[0], wire[1],
                               [](Game& game, std::string const&) { game.flags["dead"] = 1; }});
        }
    }
    for (std::string const contact : {"object 1", "object 2"}) {
        scripts.push_back({EventScript::On::collision, contact, "", check});
        scripts.push_back({EventScript::On::separation, contact, "", check});
    }
    scripts.push_back(machinery(hoist));
    return scripts;
}

// Also each wire with the devices on it, a missing generator, and other motors.
ScriptSet withEverything(Setting const& setting) {
    ScriptSet scripts;
    for (auto const& wire : setting.level.at("connections")) {
        std::string const a = wire[0];
        std::string const b = wire[1];
        std::string const flag = a == "generator"               ? "generator cut"
                                 : a == "alarm" || b == "alarm" ? "alarm cut"
                                                                : "gate cut";
        scripts.push_back({EventScript::On::wireCut, a, b,
                           [flag](Game& game, std::string const&) { game.flags[flag] = 1; }});
    }
    auto const check = [](Game& game, std::string const&) {
        game.flags["main"] = 0;
        game.flags["portable"] = 0;
        for (std::string const& bar : game.touched("object 2")) {
            if (isMarkedConducting(game, bar) && game.prefab(bar) != "battery +" &&
                game.touching(bar, "object 1")) {
                game.flags["main"] = 1;
            }
            if (game.prefab(bar) == "battery +") {
                game.flags["portable"] = 1;
            }
        }
    };
    for (std::string const contact : {"object 1", "object 2"}) {
        scripts.push_back({EventScript::On::collision, contact, "", check});
        scripts.push_back({EventScript::On::separation, contact, "", check});
    }
    double const torque = stated(setting, "wheel", "electric_motor", "torque", 150);
    scripts.push_back({EventScript::On::update, "", "", [torque](Game& game, std::string const&) {
                           bool const main = game.flags["main"] > 0 && !(game.flags["generator cut"] > 0) &&
                                             game.exists("generator");
                           bool const power = main || game.flags["portable"] > 0;
                           if (power && !(game.flags["gate cut"] > 0) && game.velocity("gate").y < 1) {
                               game.push("gate", {0, torque * ratio});
                           }
                           game.light("alarm", power && !(game.flags["alarm cut"] > 0));
                       }});
    return scripts;
}

class GateScene final : public Scene {
public:
    std::string title() const override { return "The gate"; }
    Setting asDescribed(Stage const& stage) const override {
        return {.level = stage.levelOf("tests/conventional/levels/gate.json")};
    }
    Stage::Watch watch() const override { return {.frames = 480, .pair = {}, .devices = {"alarm"}}; }
    std::string outcome(Film const& film, bool) const override {
        bool const raised = film.end("gate").at.y > film.poses.front().at("gate").at.y + raisedBy;
        return described(raised || !film.joints.contains("rail"), film.on.contains("alarm"));
    }
    std::string right(Setting const& setting, Facts const& facts, Film const& bodies) const override {
        Statement const statement(facts, setting, bodies);
        return described(wayIsFree(statement, bodies), statement.inCircuit("alarm", statement.frames()));
    }
    std::vector<Effort> efforts() const override {
        return {{"as specified", asSpecified},
                {"with the alternatives of 3.1", withAlternatives},
                {"and with each wire, the generator and other motors", withEverything}};
    }
    std::vector<Perturbation> perturbations() const override {
        auto const patch = [](Setting& setting, Random& random, std::vector<std::string> const& parts) {
            takeAway(setting, "patch");
            add(setting, "tool", random.oneOf(parts), {-2.1 + random.between(-0.05, 0.05), 1.25},
                random.between(-5, 5));
        };
        return {
            {"the wire shifted",
             [](Setting& setting, Random& random) {
                 shift(setting, "patch", random.between(-0.1, 0.1), random.between(-0.1, 0.3),
                       random.between(-10, 10));
             }},
            {"another piece for the wire",
             [patch](Setting& setting, Random& random) {
                 patch(setting, random, {"steel bar", "spanner", "switch lever", "wooden bar"});
             }},
            {"no piece at all", [](Setting& setting, Random&) { takeAway(setting, "patch"); }},
            {"a wire cut", [](Setting& setting, Random& random) { cutAny(setting, random, 1, 300); }},
            {"a portable generator, and no piece",
             [](Setting& setting, Random& random) {
                 takeAway(setting, "patch");
                 add(setting, "portable generator", "battery +", {random.chance(0.7) ? -1.5 : -2.7, 1.25}, 0,
                     {{"fixed", false}});
             }},
            {"a truck",
             [](Setting& setting, Random& random) {
                 add(setting, "truck", "", {3.2, 0.52}, 0,
                     {{"material", "steel"},
                      {"density", 7800},
                      {"friction", 0.7},
                      {"conductor", false},
                      {"magnetic_strength", false},
                      {"shape", {{{"form", "box"}, {"width", 2}, {"height", 1}}}},
                      {"velocity", {-random.between(5, 7), 0}}});
             }},
            {"a heavier gate",
             [](Setting& setting, Random& random) {
                 (*find(setting, "gate"))["properties"]["density"] =
                     random.oneOf(std::vector<int>{350, 900, 2500});
             }},
            {"another motor",
             [](Setting& setting, Random& random) {
                 (*find(setting, "wheel"))["properties"]["electric_motor"]["torque"] =
                     random.oneOf(std::vector<int>{-150, 40, 220});
             }},
            {"something above the gate",
             [](Setting& setting, Random& random) {
                 add(setting, "beam", "", {1.5 + random.between(-0.1, 0.1), 1.75}, 0,
                     {{"material", "wood"},
                      {"fixed", true},
                      {"shape", {{{"form", "box"}, {"width", 0.6}, {"height", 0.1}}}}});
             }},
            {"wood on the contacts",
             [](Setting& setting, Random& random) {
                 add(setting, "cover", "wooden bar", {-2.1 + random.between(-0.05, 0.05), 1.02});
             }},
            {"no generator", [](Setting& setting, Random&) { takeAway(setting, "generator"); }},
        };
    }
};

} // namespace
} // namespace gate_scene

std::unique_ptr<Scene> gateScene() {
    return std::make_unique<gate_scene::GateScene>();
}

} // namespace trembler::conventional
