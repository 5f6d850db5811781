#include "lua/sandbox/number_text.hpp"
#include "lua/sandbox/sandbox.hpp"
#include "tests/fuzz/play.hpp"
#include "tests/fuzz/targets.hpp"

#include <lua.hpp>

namespace trembler::lua {
namespace {

/// Runs the text as a chunk, three times: it is stopped at the same instruction, within its limits.
void runAsChunk(std::string_view text) {
    ScriptLimits const limits;
    Sandbox one(limits);
    Sandbox other(limits);
    auto const refused = one.load(text, "fuzz.lua");
    auto const refusedAgain = other.load(text, "fuzz.lua");
    require(refused.has_value() == refusedAgain.has_value(), "a text is refused only now and then");
    if (refused) {
        require(!refused->message.empty(), "a refusal says nothing");
        return;
    }
    for (int turn = 0; turn < 3; ++turn) {
        auto const run = [](Sandbox& sandbox) {
            return sandbox.turn(1, [&](lua_State* L) {
                sandbox.pushChunk(L);
                sandbox.callScript(L, 0, 0);
            });
        };
        auto const failed = run(one);
        auto const failedAgain = run(other);
        require((failed ? failed->message : "") == (failedAgain ? failedAgain->message : ""),
                "messages differ");
        require(one.instructions() == other.instructions(), "instructions differ");
        require(one.instructions() <= limits.instructions + limits.instructionsPerObject,
                "too many instructions");
        require(one.memory().used() <= limits.memory, "too much memory");
    }
}

} // namespace

void fuzzScriptText(std::string_view bytes) {
    runAsChunk(bytes);
    std::string const text(bytes);
    if (text.find("interaction") != std::string::npos) {
        playTwice(text, 5);
        return;
    }
    playTwice(
        "return interaction { name = \"Dynamics <- Fuzz\", calls = \"Dynamics\", restless = true,\n"
        "reads = { \"Position\", \"Velocity\", \"Mass\", \"Shape\", \"Joint\", \"contacts\" }, each = { "
        "\"Velocity\" },\nparams = { p = { default = 1, min = 0, max = 2 } },\nstore = { object = { n = 0, "
        "on = true }, script = { v = vec2(0, 0), s = \"\" } },\napply = function(object, params, out, store, "
        "frame)\n" +
            text + "\nend }",
        5);
}

} // namespace trembler::lua
