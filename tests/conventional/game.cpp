#include "tests/conventional/game.hpp"

#include "physics/dynamics/calls.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "runtime/object/name.hpp"
#include "runtime/placement.hpp"

namespace trembler::conventional {
namespace {

std::pair<std::string, std::string> inOrder(std::string const& a, std::string const& b) {
    return a < b ? std::pair(a, b) : std::pair(b, a);
}

} // namespace

/// Runs scripts: an interaction with Dynamics like any other.
class ScriptRunner final : public Interaction<ScriptRunner, DynamicsRole,
                                              Reads<Name, Contacts, Position, Rotation, Velocity, Mass>> {
public:
    static constexpr ComponentText text{
        .name = "Dynamics <- Scripts", .effect = "scripts", .level = "", .work = "Runs scripts."};
    using Activation = NeedsAll<>;
    static constexpr Coverage memory = leftOut("a conventional game has no state hash");

    ScriptRunner(ScriptSet scripts, std::vector<Setting::Cut> cuts, std::shared_ptr<Game> game)
        : scripts_(std::move(scripts)), cuts_(std::move(cuts)), game_(std::move(game)) {}
    [[nodiscard]] bool restless() const { return true; }

    void apply(Access& access) {
        Game& game = *game_;
        game.frame_ = access.frame();
        look(access);
        auto const before = std::exchange(game.touching_, touchingNow(access));
        using On = EventScript::On;
        for (Setting::Cut const& cut : cuts_) {
            if (cut.frame == game.frame_) {
                game.cut_.insert(inOrder(cut.a, cut.b));
                tell(On::wireCut, cut.a, cut.b);
            }
        }
        for (auto const& [a, b] : game.touching_) {
            if (!before.contains({a, b})) {
                tell(On::collision, a, b);
            }
        }
        for (auto const& [a, b] : before) {
            if (!game.touching_.contains({a, b})) {
                tell(On::separation, a, b);
            }
        }
        for (TouchingPair const& pair :
             access.read<Contacts>().brief) { // begun and ended since the last frame
            auto const [a, b] = inOrder(names_[pair.a], names_[pair.b]);
            game.touching_.insert({a, b});
            tell(On::collision, a, b);
            game.touching_.erase({a, b});
            tell(On::separation, a, b);
        }
        for (EventScript const& script : scripts_) {
            if (script.on == On::update) {
                script.run(game, "");
            }
        }
        for (auto const& [id, force] : game.pushes_) {
            access.call(AddForce{id, force});
        }
        for (auto const& [id, torque] : game.turns_) {
            access.call(AddTorque{id, torque});
        }
        game.pushes_.clear();
        game.turns_.clear();
    }

private:
    void look(Access& access) {
        Game& game = *game_;
        game.bodies_.clear();
        names_.clear();
        auto const& names = access.read<Name>();
        for (std::size_t row = 0; row < names.size(); ++row) {
            ObjectId const id = names.owners()[row];
            std::string const& name = names.values()[row].value;
            names_[id] = name;
            Game::Body& body = game.bodies_[name];
            body.id = id;
            if (Position const* const position = access.read<Position>().find(id)) {
                body.pose.at = position->value;
            }
            if (Rotation const* const rotation = access.read<Rotation>().find(id)) {
                body.pose.angle = rotation->angle;
            }
            if (Velocity const* const velocity = access.read<Velocity>().find(id)) {
                body.velocity = velocity->value;
            }
            if (Mass const* const mass = access.read<Mass>().find(id)) {
                body.mass = mass->value;
            }
        }
    }
    std::set<std::pair<std::string, std::string>> touchingNow(Access& access) {
        std::set<std::pair<std::string, std::string>> now;
        for (TouchingPair const& pair : access.read<Contacts>().current) {
            now.insert(inOrder(names_[pair.a], names_[pair.b]));
        }
        return now;
    }
    void tell(EventScript::On on, std::string const& a, std::string const& b) {
        for (EventScript const& script : scripts_) {
            if (script.on != on) {
                continue;
            }
            for (auto const& [object, other] : {std::pair(a, b), std::pair(b, a)}) {
                if (script.object == object && (script.other.empty() || script.other == other)) {
                    script.run(*game_, other);
                }
            }
        }
    }

    ScriptSet scripts_;
    std::vector<Setting::Cut> cuts_;
    std::shared_ptr<Game> game_;
    std::map<ObjectId, std::string> names_;

public:
    static void setPrefabs(Game& game, nlohmann::json const& level) {
        for (auto const& object : level.at("objects")) {
            game.prefabs_[object.at("name")] = object.value("part", std::string());
        }
    }
};

bool Game::exists(std::string const& name) const {
    return bodies_.contains(name);
}
Vec2 Game::position(std::string const& name) const {
    auto const at = bodies_.find(name);
    return at == bodies_.end() ? Vec2{} : at->second.pose.at;
}
double Game::angle(std::string const& name) const {
    auto const at = bodies_.find(name);
    return at == bodies_.end() ? 0 : at->second.pose.angle;
}
Vec2 Game::velocity(std::string const& name) const {
    auto const at = bodies_.find(name);
    return at == bodies_.end() ? Vec2{} : at->second.velocity;
}
bool Game::touching(std::string const& a, std::string const& b) const {
    return touching_.contains(inOrder(a, b));
}
std::vector<std::string> Game::touched(std::string const& name) const {
    std::vector<std::string> all;
    for (auto const& [a, b] : touching_) {
        if (a == name || b == name) {
            all.push_back(a == name ? b : a);
        }
    }
    return all;
}
std::string Game::prefab(std::string const& name) const {
    auto const at = prefabs_.find(name);
    return at == prefabs_.end() ? std::string() : at->second;
}
double Game::mass(std::string const& name) const {
    auto const at = bodies_.find(name);
    return at == bodies_.end() ? 0 : at->second.mass;
}
bool Game::isCut(std::string const& a, std::string const& b) const {
    return cut_.contains(inOrder(a, b));
}
void Game::push(std::string const& name, Vec2 force) {
    if (auto const at = bodies_.find(name); at != bodies_.end()) {
        pushes_.emplace_back(at->second.id, force);
    }
}
void Game::turn(std::string const& name, double torque) {
    if (auto const at = bodies_.find(name); at != bodies_.end()) {
        turns_.emplace_back(at->second.id, torque);
    }
}
void Game::light(std::string const& name, bool on) {
    if (on) {
        lit.insert(name);
    } else {
        lit.erase(name);
    }
}

void registerScripts(Registry& registry, ScriptSet const& scripts, Setting const& setting,
                     std::shared_ptr<Game> const& game) {
    ScriptRunner::setPrefabs(*game, setting.level);
    registry.component(Registration{&ScriptRunner::describeSelf(),
                                    [scripts, cuts = setting.cuts, game]() -> std::unique_ptr<Component> {
                                        return std::make_unique<ScriptRunner>(scripts, cuts, game);
                                    },
                                    nullptr});
}

} // namespace trembler::conventional
