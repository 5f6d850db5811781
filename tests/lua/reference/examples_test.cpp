// Every example of the reference, in a world in which it applies.
#include "lua/reference/examples.hpp"
#include "lua/reference/function_examples.hpp"
#include "physics/buoyancy/properties/spared_by.hpp"
#include "puzzle/data/game_data.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/lua/support/script_world.hpp"

#include <filesystem>
#include <set>

namespace trembler::lua {
namespace {

std::unique_ptr<World> worldOf(ScriptedGame const& game) {
    static GameData const plain;
    static std::filesystem::path const file =
        std::filesystem::path(TREMBLER_SOURCE_DIR) / "tests/lua/reference/world.json";
    auto world = buildWorld(game.registry, loadLevel(game.registry, file), plain.parts);
    // No level can state this; runs of `trembler why` set it.
    Store& store = world->store();
    store.column<SparedBy>().set(store.find("crate"), {{store.find("pool")}});
    return world;
}

Reference const& reference() {
    static Registry const registry = [] {
        Registry made;
        registerEffects(made);
        return made;
    }();
    static Reference const made = makeReference(registry);
    return made;
}

TEST(PropertyExamples, ReadEveryPropertyOfAWorldThatHasThemAll) {
    std::vector<std::string> sources;
    for (ReferenceProperty const& property : reference().properties) {
        sources.push_back(property.example);
    }
    ScriptedGame const game(sources);
    auto const world = worldOf(game);
    std::set<std::string> said;
    for (int frame = 0; frame < 60; ++frame) {
        world->step();
        for (ScriptMessage const& message : game.log->take()) {
            EXPECT_FALSE(message.error) << message.script << ": " << message.text;
            said.insert(message.script);
        }
    }
    ASSERT_EQ(game.mods.front().interactions.size(), reference().properties.size());
    for (std::size_t i = 0; i < reference().properties.size(); ++i) {
        Manifest const& script = game.mods.front().interactions[i];
        EXPECT_GE(statusOf(*world, script.name).updates, 1U)
            << script.name << ": no object of the world has it";
        if (reference().properties[i].home !=
            PropertyHome::state) { // some states are lists of what did not happen
            EXPECT_TRUE(said.contains(script.name)) << script.name;
        }
    }
}

// Whether the call of the example has an effect: the hash covers every held or pending call.
TEST(FunctionExamples, MakeTheirCalls) {
    for (ReferenceFunction const& function : reference().functions) {
        std::string const call = "out." + std::string(function.call->text.name);
        ASSERT_NE(function.example.find(call), std::string::npos) << call;
        std::string without = function.example;
        for (std::size_t at = 0; (at = without.find(call, at)) != std::string::npos;) {
            without.replace(at, call.size(), "assert"); // which takes the same arguments and does nothing
        }
        ScriptedGame const game({function.example});
        ScriptedGame const other({without});
        auto const world = worldOf(game);
        auto const idle = worldOf(other);
        bool differs = false;
        for (int frame = 0; frame < 60 && !differs; ++frame) {
            world->step();
            idle->step();
            differs = world->stateHash() != idle->stateHash();
        }
        EXPECT_TRUE(differs) << call << " is never called";
        EXPECT_EQ(game.messages(), "") << function.example;
        EXPECT_EQ(other.messages(), "") << without;
    }
}

TEST(FunctionExamples, BelongToFunctionsThatThereAre) {
    for (FunctionExample const& example : functionExamples()) {
        EXPECT_TRUE(std::any_of(reference().functions.begin(), reference().functions.end(),
                                [&](ReferenceFunction const& function) {
                                    return function.role->name == example.role &&
                                           function.call->text.name == example.function;
                                }))
            << example.function;
    }
}

} // namespace
} // namespace trembler::lua
