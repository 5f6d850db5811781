// The scenes of the thesis that a conventional engine would script, and how they are perturbed.
#pragma once

#include "tests/conventional/play.hpp"
#include "tests/conventional/random.hpp"
#include "tests/conventional/statement.hpp"

#include <functional>
#include <memory>

namespace trembler::conventional {

/// A conventional implementation, with a stated effort.
struct Effort {
    std::string title;
    std::function<ScriptSet(Setting const&)> scripts;
};

/// A way to perturb a scene.
struct Perturbation {
    std::string kind;
    std::function<void(Setting&, Random&)> apply;
};

class Scene {
public:
    virtual ~Scene() = default;
    [[nodiscard]] virtual std::string title() const = 0;
    /// The scene as the thesis describes it.
    [[nodiscard]] virtual Setting asDescribed(Stage const& stage) const = 0;
    [[nodiscard]] virtual std::vector<Perturbation> perturbations() const = 0;
    [[nodiscard]] virtual Stage::Watch watch() const = 0;
    /// The outcome, in a word or two; of a run with all of physics, or with scripts.
    [[nodiscard]] virtual std::string outcome(Film const& film, bool scripted) const = 0;
    /// The right outcome. `bodies` is a run with rigid bodies only.
    [[nodiscard]] virtual std::string right(Setting const& setting, Facts const& facts,
                                            Film const& bodies) const = 0;
    [[nodiscard]] virtual std::vector<Effort> efforts() const = 0;
};

[[nodiscard]] std::vector<std::unique_ptr<Scene>> allScenes();
[[nodiscard]] std::unique_ptr<Scene> magnetScene();
[[nodiscard]] std::unique_ptr<Scene> doorbellScene();
[[nodiscard]] std::unique_ptr<Scene> doorScene();
[[nodiscard]] std::unique_ptr<Scene> gateScene();

/// A scene with one perturbation, or two of different kinds. The same number gives the same perturbations.
[[nodiscard]] Setting perturbed(Scene const& scene, Stage const& stage, std::uint64_t number);

/// Parts that may lie across two contacts; the last one does not conduct.
[[nodiscard]] std::vector<std::string> const& barParts();

// Editing a level. Objects are found by name; an object that another perturbation has taken away is left
// alone.
nlohmann::json* find(Setting& setting, std::string const& name);
void shift(Setting& setting, std::string const& name, double x, double y, double degrees);
void takeAway(Setting& setting, std::string const& name);
// Removes the connections of an object that stays, as only conductors can have connections.
void removeWires(Setting& setting, std::string const& name);
void add(Setting& setting, std::string const& name, std::string const& part, Vec2 at, double degrees = 0,
         nlohmann::json properties = nlohmann::json::object());
/// The player lifts an object, held at its place, from a frame on.
void lift(Setting& setting, std::string const& name, Vec2 at, int frame);
/// Cuts one of the wires, in a frame of the range.
void cutAny(Setting& setting, Random& random, int first, int last);
/// The names of all objects of a level.
[[nodiscard]] std::vector<std::string> objectNames(Setting const& setting);
/// A number that a level states of an object: property, field.
[[nodiscard]] double stated(Setting const& setting, std::string const& name, std::string const& property,
                            std::string const& field, double otherwise);

// Functions that scripts of several scenes use.
/// Prefabs that a designer has marked as conducting.
[[nodiscard]] bool isMarkedConducting(Game const& game, std::string const& name);
/// Scripts that set a flag to zero for each wire that is cut: one for each.
[[nodiscard]] ScriptSet onEveryCut(Setting const& setting, std::string const& flag);

} // namespace trembler::conventional
