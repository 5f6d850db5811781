// Experiment II: a doorbell, which interrupts its own circuit.
#include "tests/conventional/scene.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trembler::conventional {
namespace doorbell_scene { // other scenes have functions of these names, too
namespace {

constexpr std::size_t ringsOn = 3; // strikes: the bell keeps ringing

Vec2 turnedAbout(Vec2 hinge, Vec2 point, double angle) {
    return hinge + rotated(point, angle);
}

/// The centre of mass of the pieces of the striker, a box and a disc.
Vec2 centreOf(Shape const& shape) {
    double area = 0;
    Vec2 sum;
    for (ShapePiece const& piece : shape.pieces) {
        double const own = piece.form == ShapeForm::circle ? 3.14159265358979 * piece.radius * piece.radius
                                                           : piece.width * piece.height;
        area += own;
        sum += own * piece.at;
    }
    return 1 / area * sum;
}

/// The four conditions for a trembler to ring.
bool ringsOnAndOn(Statement const& statement, std::uint64_t at) {
    Facts const& facts = statement.facts();
    if (!facts.contains("bell") || !facts.contains("striker")) {
        return false;
    }
    Pose const rest = statement.pose("striker", at);
    Vec2 const hinge = rest.at;
    Fact const& striker = facts.at("striker");
    // 1. Current flows while the striker rests on its contact.
    if (!statement.inCircuit("electromagnet", at)) {
        return false;
    }
    // 2. The magnet turns the striker away from there against its weight.
    Vec2 const centre = turnedAbout(hinge, centreOf(striker.shape), rest.angle);
    Vec2 const force = statement.force("striker", centre, at) + Vec2{0, -9.81 * striker.mass};
    if (!(cross(centre - hinge, force) > 0)) {
        return false;
    }
    // 3. Nothing blocks its way to the bell.
    double const degree = 3.14159265358979 / 180;
    Statement::Moved moved;
    bool reached = false;
    for (double turn = 0; turn < 40 && !reached; turn += 0.25) {
        moved["striker"] = {hinge, rest.angle + turn * degree, true};
        for (auto const& [name, fact] : facts) {
            bool const passes = name == "striker" || name == "backboard" || name == "contact" ||
                                statement.touching("striker", name, at); // it rests on it
            if (passes || !statement.touching("striker", name, at, moved)) {
                continue;
            }
            if (name != "bell") {
                return false;
            }
            reached = true;
        }
    }
    // 4. There, the circuit is open.
    return reached && !statement.inCircuit("electromagnet", at, moved);
}

// ---- The conventional scripts

ScriptSet asSpecified(Setting const&) {
    return {{EventScript::On::collision, "switch", "", [](Game& game, std::string const&) {
                 if (game.touching("switch", "object 1") && game.touching("switch", "object 2")) {
                     for (std::size_t i = 0; i < ringsOn; ++i) {
                         game.ring(); // the sample is of a bell that keeps ringing
                     }
                 }
             }}};
}

// The four scripts and the flag with which 6.9.4 ends.
ScriptSet withAlternatives(Setting const&) {
    auto const push = [](Game& game) { game.flags["push until"] = static_cast<double>(game.frame()) + 12; };
    return {{EventScript::On::collision, "switch", "",
             [push](Game& game, std::string const&) {
                 if (game.touching("switch", "object 1") && game.touching("switch", "object 2")) {
                     game.flags["on"] = 1;
                     push(game);
                 }
             }},
            {EventScript::On::separation, "switch", "",
             [](Game& game, std::string const& other) {
                 if (other == "object 1" || other == "object 2") {
                     game.flags["on"] = 0;
                 }
             }},
            {EventScript::On::collision, "striker", "contact",
             [push](Game& game, std::string const&) {
                 if (game.flags["on"] > 0) {
                     push(game);
                 }
             }},
            {EventScript::On::collision, "bell", "", [](Game& game, std::string const&) { game.ring(); }},
            {EventScript::On::update, "", "", [](Game& game, std::string const&) {
                 if (static_cast<double>(game.frame()) < game.flags["push until"]) {
                     game.push("striker", {500, 0});
                 }
             }}};
}

// Also any conductor for the switch, wires, an object on the contact, the striker's material, the magnet's
// strength.
ScriptSet withEverything(Setting const& setting) {
    ScriptSet scripts = onEveryCut(setting, "dead");
    auto const push = [](Game& game) { game.flags["push until"] = static_cast<double>(game.frame()) + 12; };
    auto const check = [push](Game& game, std::string const&) {
        double const before = std::exchange(game.flags["on"], 0);
        for (std::string const& bar : game.touched("object 1")) {
            if (isMarkedConducting(game, bar) && game.touching(bar, "object 2")) {
                game.flags["on"] = 1;
            }
        }
        bool const rests = game.touching("striker", "contact") || game.touching("striker", "clip");
        if (before == 0 && game.flags["on"] > 0 && rests) {
            push(game);
        }
    };
    for (std::string const contact : {"object 1", "object 2"}) {
        scripts.push_back({EventScript::On::collision, contact, "", check});
        scripts.push_back({EventScript::On::separation, contact, "", check});
    }
    auto const strike = [push](Game& game, std::string const& other) {
        bool const conducts = other == "contact" || isMarkedConducting(game, other);
        if (game.flags["on"] > 0 && conducts) {
            push(game);
        }
    };
    scripts.push_back({EventScript::On::collision, "striker", "contact", strike});
    scripts.push_back({EventScript::On::collision, "striker", "clip", strike});
    scripts.push_back(
        {EventScript::On::collision, "bell", "", [](Game& game, std::string const&) { game.ring(); }});
    bool const isSteel = stated(setting, "striker", "magnetic_strength", "susceptibility", 0) > 0;
    double const strength = stated(setting, "electromagnet", "magnetic_strength", "strength", 80000);
    scripts.push_back({EventScript::On::update, "", "", [isSteel, strength](Game& game, std::string const&) {
                           bool const pushes = static_cast<double>(game.frame()) < game.flags["push until"];
                           if (pushes && isSteel && !(game.flags["dead"] > 0)) {
                               game.push("striker", {500 * strength / 80000, 0});
                           }
                       }});
    return scripts;
}

class DoorbellScene final : public Scene {
public:
    std::string title() const override { return "Experiment II"; }
    Setting asDescribed(Stage const& stage) const override {
        return {.level = stage.levelOf("levels/experiments/2-doorbell.json")};
    }
    Stage::Watch watch() const override {
        return {.frames = 600, .pair = {"striker", "bell"}, .devices = {}};
    }
    std::string outcome(Film const& film, bool scripted) const override {
        return (scripted ? film.rings : film.hits).size() >= ringsOn ? "rings on" : "does not ring on";
    }
    std::string right(Setting const& setting, Facts const& facts, Film const& bodies) const override {
        Statement const statement(facts, setting, bodies);
        // After everything has come to rest; the player acts later, or at once.
        return ringsOnAndOn(statement, 180) ? "rings on" : "does not ring on";
    }
    std::vector<Effort> efforts() const override {
        return {{"as specified", asSpecified},
                {"with the alternatives of 6.9.4", withAlternatives},
                {"and with other bars and clips, wires, materials and strengths", withEverything}};
    }
    std::vector<Perturbation> perturbations() const override {
        return {
            {"parts shifted",
             [](Setting& setting, Random& random) {
                 shift(setting, "switch", random.between(-0.2, 0.2), random.between(-0.2, 0.2),
                       random.between(-10, 10));
             }},
            {"another bar for the switch",
             [](Setting& setting, Random& random) {
                 takeAway(setting, "switch");
                 add(setting, "tool", random.oneOf(barParts()), {-2.4 + random.between(-0.05, 0.05), 1.25},
                     random.between(-5, 5));
             }},
            {"a wire cut at once", [](Setting& setting, Random& random) { cutAny(setting, random, 1, 10); }},
            {"a wire cut while it rings",
             [](Setting& setting, Random& random) { cutAny(setting, random, 400, 500); }},
            {"the switch lifted while it rings",
             [](Setting& setting, Random& random) {
                 lift(setting, "switch", {-2.4, 1.0}, 400 + static_cast<int>(random.below(100)));
             }},
            {"a wedge before the bell",
             [](Setting& setting, Random& random) {
                 add(setting, "wedge", "wooden wedge",
                     {0.47 + random.between(-0.01, 0.01), 1.96 + random.between(0, 0.02)});
             }},
            {"a clip on the contact",
             [](Setting& setting, Random& random) {
                 add(setting, "clip", random.oneOf(std::vector<std::string>{"wooden clip", "copper clip"}),
                     {0.026, 2.105});
             }},
            {"the bell taken away", [](Setting& setting, Random&) { takeAway(setting, "bell"); }},
            {"another striker",
             [](Setting& setting, Random& random) {
                 nlohmann::json& properties = (*find(setting, "striker"))["properties"];
                 properties.erase("magnetic_strength");
                 bool const copper = random.chance(0.5);
                 properties["material"] = copper ? "copper" : "wood";
                 properties["density"] = copper ? 8960 : 600;
                 if (!copper) {
                     properties["conductor"] = false;
                     removeWires(setting, "striker");
                 }
                 properties["magnetic_strength"] = false;
             }},
            {"a magnet of another strength",
             [](Setting& setting, Random& random) {
                 (*find(setting, "electromagnet"))["properties"]["magnetic_strength"]["strength"] =
                     random.oneOf(std::vector<int>{4000, 60000, 120000});
             }},
            {"a magnet behind the striker",
             [](Setting& setting, Random& random) {
                 add(setting, "brought magnet", "base magnet", {-0.6, 1.9 + random.between(-0.1, 0.1)}, 0,
                     {{"magnetic_strength", {{"strength", random.oneOf(std::vector<int>{1000, 200000})}}}});
             }},
            {"wood on the contacts",
             [](Setting& setting, Random& random) {
                 add(setting, "cover", "wooden bar", {-2.4 + random.between(-0.05, 0.05), 1.02});
             }},
        };
    }
};

} // namespace
} // namespace doorbell_scene

std::unique_ptr<Scene> doorbellScene() {
    return std::make_unique<doorbell_scene::DoorbellScene>();
}

} // namespace trembler::conventional
