// The laboratory door of section 1.1: a magnetic lock keeps it shut; a switch opens it.
#include "tests/conventional/scene.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::conventional {
namespace door_scene { // other scenes have functions of these names, too
namespace {

constexpr double openBy = 0.5; // m

nlohmann::json& springOf(Setting& setting) {
    return setting.level.at("joints").at(1);
}
/// N, with which the spring pushes the closed door: stiffness times stretch.
double pushIn(Setting const& setting) {
    nlohmann::json const& spring = setting.level.at("joints").at(1);
    double const stretch = spring.at("at_b").at(0).get<double>() - spring.at("at").at(0).get<double>() -
                           spring.at("length").get<double>();
    return spring.at("stiffness").get<double>() * stretch;
}

bool opens(Statement const& statement, Setting const& setting) {
    // A door that has left its lock does not come back, so one moment is enough.
    for (std::uint64_t frame = 40; frame <= statement.frames(); frame += 20) {
        Statement::Moved closed;
        closed["door"] = statement.facts().at("door").start;
        Vec2 const pull = statement.force("door", closed["door"].at, frame, closed);
        if (pushIn(setting) + pull.x > 0) {
            return true;
        }
    }
    return false;
}

// ---- The conventional scripts

EventScript lock(double strength) {
    return {EventScript::On::update, "", "", [strength](Game& game, std::string const&) {
                if (game.flags["unlocked"] > 0) {
                    return;
                }
                double const away = game.position("door").x - 0.915;
                double const hold = -1e5 * away - 1e4 * game.velocity("door").x;
                game.push("door", {std::max(-strength, std::min(strength, hold)), 0});
            }};
}

ScriptSet asSpecified(Setting const&) {
    return {{EventScript::On::separation, "switch", "",
             [](Game& game, std::string const&) { game.flags["unlocked"] = 1; }},
            lock(1e6)};
}

// The solutions that section 1.1 names: the switch, the main fuse, together pushing hard enough.
ScriptSet withAlternatives(Setting const& setting) {
    ScriptSet scripts = onEveryCut(setting, "unlocked");
    scripts.push_back({EventScript::On::separation, "switch", "",
                       [](Game& game, std::string const&) { game.flags["unlocked"] = 1; }});
    scripts.push_back({EventScript::On::update, "", "", [](Game& game, std::string const&) {
                           if (!game.exists("main fuse")) {
                               game.flags["unlocked"] = 1;
                           }
                       }});
    scripts.push_back(lock(2700));
    return scripts;
}

// Also tools across the contacts, a switch that never closed, a missing source, other doors and magnets.
ScriptSet withEverything(Setting const& setting) {
    ScriptSet scripts = onEveryCut(setting, "unlocked");
    auto const check = [](Game& game, std::string const&) {
        bool closed = false;
        for (std::string const& bar : game.touched("object 1")) {
            closed = closed || (isMarkedConducting(game, bar) && game.touching(bar, "object 2"));
        }
        if (!closed && game.frame() > 10) {
            game.flags["unlocked"] = 1;
        }
    };
    for (std::string const contact : {"object 1", "object 2"}) {
        scripts.push_back({EventScript::On::separation, contact, "", check});
    }
    scripts.push_back({EventScript::On::update, "", "", [check](Game& game, std::string const&) {
                           if (game.frame() == 30) {
                               check(game, "");
                           }
                           if (!game.exists("main fuse") || !game.exists("electrical source")) {
                               game.flags["unlocked"] = 1;
                           }
                       }});
    bool const isSteel = stated(setting, "door", "magnetic_strength", "susceptibility", 0) > 0;
    double const strength = stated(setting, "electromagnet", "magnetic_strength", "strength", 20000);
    scripts.push_back(lock(isSteel ? 2700 * strength / 20000 : 0));
    double const brought = stated(setting, "brought magnet", "magnetic_strength", "strength", 0);
    scripts.push_back({EventScript::On::update, "", "", [isSteel, brought](Game& game, std::string const&) {
                           Vec2 const away = game.position("brought magnet") - game.position("door");
                           if (brought > 0 && isSteel) {
                               double const square = std::max(dot(away, away), 0.01);
                               game.push("door", brought * 0.01 / (square * std::sqrt(square)) * away);
                           }
                       }});
    return scripts;
}

class DoorScene final : public Scene {
public:
    std::string title() const override { return "The laboratory door"; }
    Setting asDescribed(Stage const& stage) const override {
        Setting setting{.level = stage.levelOf("tests/conventional/levels/door.json")};
        lift(setting, "switch", {-2.1, 1.005}, 120);
        return setting;
    }
    Stage::Watch watch() const override { return {.frames = 420, .pair = {}, .devices = {}}; }
    std::string outcome(Film const& film, bool) const override {
        return film.end("door").at.x > film.poses.front().at("door").at.x + openBy ? "open" : "shut";
    }
    std::string right(Setting const& setting, Facts const& facts, Film const& bodies) const override {
        Statement const statement(facts, setting, bodies);
        return opens(statement, setting) ? "open" : "shut";
    }
    std::vector<Effort> efforts() const override {
        return {{"as specified", asSpecified},
                {"with the alternatives of 1.1", withAlternatives},
                {"and with tools, sources, materials, strengths and magnets", withEverything}};
    }
    std::vector<Perturbation> perturbations() const override {
        auto const hands = [](Setting& setting) { setting.inputs = nlohmann::json::array(); };
        return {
            {"nobody touches the switch", [hands](Setting& setting, Random&) { hands(setting); }},
            {"another moment",
             [hands](Setting& setting, Random& random) {
                 hands(setting);
                 lift(setting, "switch", {-2.1, 1.005}, 60 + static_cast<int>(random.below(200)));
             }},
            {"a tool beneath the switch",
             [](Setting& setting, Random& random) {
                 shift(setting, "switch", 0, 0.3, 0);
                 add(setting, "tool", random.oneOf(barParts()), {-2.1 + random.between(-0.05, 0.05), 1.13},
                     random.between(-2, 2));
             }},
            {"another bar for the switch",
             [](Setting& setting, Random& random) {
                 takeAway(setting, "switch");
                 add(setting, "tool", random.oneOf(barParts()), {-2.1, 1.02});
             }},
            {"a wire cut, nobody touches the switch",
             [hands](Setting& setting, Random& random) {
                 hands(setting);
                 cutAny(setting, random, 60, 300);
             }},
            {"the main fuse removed, nobody touches the switch",
             [hands](Setting& setting, Random& random) {
                 hands(setting);
                 std::erase_if(setting.cuts, [](Setting::Cut const& cut) { // there is no wire left to cut
                     return cut.a == "main fuse" || cut.b == "main fuse";
                 });
                 if (find(setting, "main fuse") != nullptr) {
                     setting.inputs.push_back(
                         {{"frame", 60 + static_cast<int>(random.below(200))}, {"remove", "main fuse"}});
                 }
             }},
            {"another push, nobody touches the switch",
             [hands](Setting& setting, Random& random) {
                 hands(setting);
                 springOf(setting)["stiffness"] = random.oneOf(std::vector<int>{100, 500, 3000});
             }},
            {"a door of wood",
             [](Setting& setting, Random&) {
                 nlohmann::json& properties = (*find(setting, "door"))["properties"];
                 properties["material"] = "wood";
                 properties["density"] = 600;
                 properties["magnetic_strength"] = false;
             }},
            {"no source", [](Setting& setting, Random&) { takeAway(setting, "electrical source"); }},
            {"a magnet at the door",
             [](Setting& setting, Random& random) {
                 add(setting, "brought magnet", "base magnet", {0.55, 0.35 + random.between(-0.1, 0.1)}, 0,
                     {{"magnetic_strength", {{"strength", random.oneOf(std::vector<int>{2500, 60000})}}}});
             }},
            {"a lock of another strength, nobody touches the switch",
             [hands](Setting& setting, Random& random) {
                 hands(setting);
                 (*find(setting, "electromagnet"))["properties"]["magnetic_strength"]["strength"] =
                     random.oneOf(std::vector<int>{1500, 10000, 40000});
             }},
        };
    }
};

} // namespace
} // namespace door_scene

std::unique_ptr<Scene> doorScene() {
    return std::make_unique<door_scene::DoorScene>();
}

} // namespace trembler::conventional
