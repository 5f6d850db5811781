// A conventional game engine: rigid bodies, and scripts that are attached to events of objects.
#pragma once

#include "runtime/world/registry.hpp"
#include "tests/conventional/film.hpp"

#include <functional>
#include <memory>
#include <optional>

namespace trembler::conventional {

/// The part of the game that scripts can use. All names are those of objects.
class Game {
public:
    [[nodiscard]] bool exists(std::string const& name) const;
    [[nodiscard]] Vec2 position(std::string const& name) const;
    [[nodiscard]] double angle(std::string const& name) const; ///< rad
    [[nodiscard]] Vec2 velocity(std::string const& name) const;
    [[nodiscard]] bool touching(std::string const& a, std::string const& b) const;
    /// All objects that touch an object.
    [[nodiscard]] std::vector<std::string> touched(std::string const& name) const;
    /// From which prefab an object was made; empty if from none.
    [[nodiscard]] std::string prefab(std::string const& name) const;
    [[nodiscard]] double mass(std::string const& name) const; ///< kg
    [[nodiscard]] bool isCut(std::string const& a,
                             std::string const& b) const; ///< the rope or wire of the two
    [[nodiscard]] std::uint64_t frame() const { return frame_; }
    /// Pushes an object in this frame; N.
    void push(std::string const& name, Vec2 force);
    void turn(std::string const& name, double torque); ///< N m
    void ring() { rings.push_back(frame_); }
    void light(std::string const& name, bool on);
    /// Variables of the scripts.
    std::map<std::string, double> flags;

    std::vector<std::uint64_t> rings;
    std::set<std::string> lit;

private:
    friend class ScriptRunner;
    struct Body {
        ObjectId id;
        Pose pose;
        Vec2 velocity;
        double mass = 0;
    };
    std::map<std::string, Body> bodies_;
    std::set<std::pair<std::string, std::string>> touching_;
    std::set<std::pair<std::string, std::string>> cut_;
    std::map<std::string, std::string> prefabs_;
    std::vector<std::pair<ObjectId, Vec2>> pushes_;
    std::vector<std::pair<ObjectId, double>> turns_;
    std::uint64_t frame_ = 0;
};

/// One script, attached to an event. An empty `other` means any object.
struct EventScript {
    enum class On { collision, separation, wireCut, update } on = On::update;
    std::string object;
    std::string other;
    std::function<void(Game&, std::string const& other)> run;
};
using ScriptSet = std::vector<EventScript>;

/// Adds the component that runs the scripts, as the last interaction. `game` records their effects.
void registerScripts(Registry& registry, ScriptSet const& scripts, Setting const& setting,
                     std::shared_ptr<Game> const& game);

} // namespace trembler::conventional
