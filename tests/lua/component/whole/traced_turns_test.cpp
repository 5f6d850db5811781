// A trace changes no run: where it has no room for a script's calls, the run stops, and the script sees
// nothing.
#include "tests/lua/support/script_world.hpp"

#include <stdexcept>

namespace trembler::lua {
namespace {

TEST(TracedTurns, StopTheRunWhereAFrameHasTooManyEvents) {
    ScriptedGame const game({"return interaction { name = \"Dynamics <- Test\", calls = \"Dynamics\", reads "
                             "= {}, restless = true,\n"
                             "each = { \"Mass\" }, limits = { instructions = 200000, instructions_per_object "
                             "= 2000, calls = 1000, "
                             "calls_per_object = 100 },\n"
                             "apply = function(object, params, out)\n"
                             "  local good, message = pcall(function() for i = 1, 100 do "
                             "out.addImpulse(object, 0, 0, 0, 1) end end)\n"
                             "  if not good then log(message) end\nend }"});
    WorldOptions options;
    options.trace = true;
    World world(game.registry, options);
    constexpr int boxes = 2630; // with 100 events each: above 2^18
    for (int i = 0; i < boxes; ++i) {
        (void)addBox(world.store(), "b" + std::to_string(i), {3.0 * i, 0});
    }
    world.start();
    std::string why;
    try {
        world.step();
    } catch (std::length_error const& error) {
        why = error.what();
    }
    EXPECT_NE(why.find("Dynamics <- Test records more than 262144 events in frame 1; expected"),
              std::string::npos)
        << why;
    EXPECT_EQ(game.messages(), "");
}

} // namespace
} // namespace trembler::lua
