// Experiment I: a switch, an electromagnet, and the object that it lifts.
#include "tests/conventional/scene.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::conventional {
namespace magnet_scene { // other scenes have functions of these names, too
namespace {

constexpr double liftedBy = 0.5; // m

/// The object under the magnet: the one of the level, or its replacement.
std::string loadIn(Facts const& facts) {
    return facts.contains("metal object") ? "metal object" : "other object";
}

/// Follows a point with the mass of the load on a floor, under the magnets' forces and its weight, in small
/// steps of its own. A ball rolls, so half of its mass more resists motion along the floor; any other load
/// slides where the force along the floor exceeds half of its pressure on the floor.
bool isHeldUpAtTheEnd(Statement const& statement, std::string const& load) {
    constexpr std::uint64_t every = 5; // frames between two evaluations of the circuit
    constexpr int steps = 20;          // per frame
    Fact const& fact = statement.facts().at(load);
    if (!(fact.susceptibility > 0)) {
        return false;
    }
    bool const rolls = fact.shape.pieces.front().form == ShapeForm::circle;
    double const ceiling = [&] {
        Fact const& magnet = statement.facts().at("electromagnet");
        return magnet.start.at.y - 0.25 - (rolls ? fact.shape.pieces.front().radius : 0.3);
    }();
    Vec2 at = statement.pose(load, 60).at;
    double const floor = at.y;
    Vec2 velocity;
    for (std::uint64_t frame = 60; frame <= statement.frames(); ++frame) {
        // The force at the beginning of the frame: Coulomb's law hardly changes over a frame's few
        // millimetres.
        Vec2 const pull = statement.force(load, at, frame - frame % every);
        for (int step = 0; step < steps; ++step) {
            double const dt = 1.0 / 60 / steps;
            Vec2 const force = pull + Vec2{0, -9.81 * fact.mass};
            bool const lies = at.y <= floor + 1e-9;
            Vec2 acceleration = 1 / fact.mass * force;
            if (lies && force.y <= 0) {
                acceleration = {rolls ? force.x / (1.5 * fact.mass)
                                : std::abs(force.x) > 0.5 * -force.y
                                    ? (force.x - std::copysign(0.5 * -force.y, force.x)) / fact.mass
                                    : 0,
                                0};
                velocity.y = 0;
                if (!rolls && acceleration.x == 0) {
                    velocity.x = 0;
                }
            }
            velocity += dt * acceleration;
            at += dt * velocity;
            if (at.y < floor) {
                at.y = floor;
                velocity.y = 0;
            }
            if (at.y > ceiling) {
                at.y = ceiling;
                velocity = {};
            }
        }
    }
    return at.y > floor + liftedBy;
}

// ---- The conventional scripts

void pushLoads(Game& game, double force, std::vector<std::string> const& loads) {
    for (std::string const& load : loads) {
        if (std::abs(game.position(load).x - 1.8) < 0.5) {
            game.push(load, {0, force});
        }
    }
}

ScriptSet asSpecified(Setting const&) {
    auto const check = [](Game& game, std::string const&) {
        if (game.touching("switch", "object 1") && game.touching("switch", "object 2")) {
            game.flags["magnet"] = 1;
        }
    };
    return {{EventScript::On::collision, "switch", "", check},
            {EventScript::On::update, "", "", [](Game& game, std::string const&) {
                 if (game.flags["magnet"] > 0) {
                     pushLoads(game, 800, {"metal object"});
                 }
             }}};
}

// The four alternatives of 6.8.4: the switch is lifted, a wire is cut, another conductor, another metal
// object.
ScriptSet withAlternatives(Setting const& setting) {
    auto const check = [](Game& game, std::string const&) {
        game.flags["closed"] = 0;
        for (std::string const& bar : game.touched("object 1")) {
            if (isMarkedConducting(game, bar) && game.touching(bar, "object 2")) {
                game.flags["closed"] = 1;
            }
        }
    };
    ScriptSet scripts = onEveryCut(setting, "dead");
    for (std::string const contact : {"object 1", "object 2"}) {
        scripts.push_back({EventScript::On::collision, contact, "", check});
        scripts.push_back({EventScript::On::separation, contact, "", check});
    }
    scripts.push_back({EventScript::On::update, "", "", [](Game& game, std::string const&) {
                           std::vector<std::string> loads;
                           for (std::string const load : {"metal object", "other object"}) {
                               std::string const prefab = game.prefab(load);
                               if (prefab == "iron ball" || prefab == "steel ball") {
                                   loads.push_back(load);
                               }
                           }
                           if (game.flags["closed"] > 0 && !(game.flags["dead"] > 0)) {
                               pushLoads(game, 800, loads);
                           }
                       }});
    return scripts;
}

// Also a pull that falls off with the distance, strengths chosen by designers, and magnets that are brought
// in.
ScriptSet withEverything(Setting const& setting) {
    ScriptSet scripts = withAlternatives(setting);
    scripts.pop_back();
    double const strength = stated(setting, "electromagnet", "magnetic_strength", "strength", 150000);
    auto const pull = [](Game& game, std::string const& magnet, Vec2 pole, double power) {
        for (std::string const load : {"metal object", "other object"}) {
            std::string const prefab = game.prefab(load);
            if (prefab == "iron ball" || prefab == "steel ball") {
                Vec2 const away = game.position(magnet) + pole - game.position(load);
                double const square = std::max(dot(away, away), 0.01);
                game.push(load, power * 0.01 / (square * std::sqrt(square)) * away);
            }
        }
    };
    scripts.push_back({EventScript::On::update, "", "", [pull, strength](Game& game, std::string const&) {
                           if (game.flags["closed"] > 0 && !(game.flags["dead"] > 0)) {
                               pull(game, "electromagnet", {0, -0.1}, strength);
                           }
                       }});
    double const brought = stated(setting, "brought magnet", "magnetic_strength", "strength", 0);
    scripts.push_back({EventScript::On::update, "", "", [pull, brought](Game& game, std::string const&) {
                           if (game.exists("brought magnet")) {
                               pull(game, "brought magnet", {}, brought);
                           }
                       }});
    return scripts;
}

class MagnetScene final : public Scene {
public:
    std::string title() const override { return "Experiment I"; }
    Setting asDescribed(Stage const& stage) const override {
        return {.level = stage.levelOf("levels/experiments/1-switched-electromagnet.json")};
    }
    Stage::Watch watch() const override { return {.frames = 480, .pair = {}, .devices = {}}; }
    std::string outcome(Film const& film, bool) const override {
        for (std::string const load : {"metal object", "other object"}) {
            if (film.end(load).there) {
                return film.end(load).at.y > film.poses.front().at(load).at.y + liftedBy ? "lifted"
                                                                                         : "not lifted";
            }
        }
        return "nothing there";
    }
    std::string right(Setting const& setting, Facts const& facts, Film const& bodies) const override {
        Statement const statement(facts, setting, bodies);
        return isHeldUpAtTheEnd(statement, loadIn(facts)) ? "lifted" : "not lifted";
    }
    std::vector<Effort> efforts() const override {
        return {{"as specified", asSpecified},
                {"with the four alternatives of 6.8.4", withAlternatives},
                {"and with distances, strengths and other magnets", withEverything}};
    }
    std::vector<Perturbation> perturbations() const override {
        auto const tool = [](Setting& setting, Random& random) {
            add(setting, "tool", random.oneOf(barParts()), {-2.1 + random.between(-0.05, 0.05), 1.25},
                random.between(-5, 5));
        };
        return {
            {"parts shifted",
             [](Setting& setting, Random& random) {
                 shift(setting, "switch", random.between(-0.3, 0.3), random.between(-0.3, 0.3),
                       random.between(-15, 15));
                 shift(setting, "metal object", random.between(-0.25, 0.25), 0, random.between(-180, 180));
             }},
            {"another bar for the switch",
             [tool](Setting& setting, Random& random) {
                 takeAway(setting, "switch");
                 tool(setting, random);
             }},
            {"another load",
             [](Setting& setting, Random& random) {
                 takeAway(setting, "metal object");
                 add(setting, "other object",
                     random.oneOf(std::vector<std::string>{"steel ball", "wooden ball", "rubber ball"}),
                     {1.8 + random.between(-0.2, 0.2), 0.16});
             }},
            {"a wire cut", [](Setting& setting, Random& random) { cutAny(setting, random, 1, 300); }},
            {"a tool beneath the switch, which is lifted",
             [tool](Setting& setting, Random& random) {
                 tool(setting, random);
                 lift(setting, "switch", {-2.1, 1.1}, 150 + static_cast<int>(random.below(60)));
             }},
            {"the switch lifted",
             [](Setting& setting, Random& random) {
                 lift(setting, "switch", {-2.1, 1.0}, 120 + static_cast<int>(random.below(120)));
             }},
            {"a magnet beneath the load",
             [](Setting& setting, Random& random) {
                 add(setting, "brought magnet", "base magnet", {1.8 + random.between(-0.1, 0.1), -0.45}, 0,
                     {{"magnetic_strength",
                       {{"strength", random.oneOf(std::vector<int>{2500, 20000, 100000})}}}});
             }},
            {"a magnet of another strength",
             [](Setting& setting, Random& random) {
                 (*find(setting, "electromagnet"))["properties"]["magnetic_strength"]["strength"] =
                     random.oneOf(std::vector<int>{40000, 80000, 220000});
             }},
            {"wood on the contacts",
             [](Setting& setting, Random& random) {
                 add(setting, "cover", "wooden bar", {-2.1 + random.between(-0.05, 0.05), 1.02});
             }},
            {"a heavier load",
             [](Setting& setting, Random& random) {
                 if (nlohmann::json* const load = find(setting, "metal object")) {
                     (*load)["properties"]["density"] = random.oneOf(std::vector<int>{4000, 7000, 14000});
                 }
             }},
        };
    }
};

} // namespace
} // namespace magnet_scene

std::unique_ptr<Scene> magnetScene() {
    return std::make_unique<magnet_scene::MagnetScene>();
}

} // namespace trembler::conventional
