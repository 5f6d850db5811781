#include "lua/mods/lint.hpp"

#include <gtest/gtest.h>

namespace trembler::lua {
namespace {

std::string lintOf(std::string const& text) {
    Problems problems;
    Manifest const manifest = readManifest(text, "a.lua", problems);
    problems.throwIfAny();
    std::string all;
    for (Diagnostic const& diagnostic : lint(manifest)) {
        all += std::to_string(diagnostic.line) + ": " + diagnostic.message + "\n";
    }
    return all;
}

// 'Position' selects the objects, so it is needed although apply does not read it.
TEST(Lint, FindsWhatIsDeclaredAndNeverMentionedAgain) {
    EXPECT_EQ(lintOf(R"(return interaction {
  name = "Dynamics <- Test", calls = "Dynamics",
  reads = { "Mass", "Velocity", "Position" },
  each = { "Mass", "Position" },
  params = { force = { default = 1, min = 0, max = 2, text = "It is used" },
    strength = { default = 1, min = 0 } },
  store = { object = { count = 0, unused = 0 } },
  apply = function(object, params, out, store) --[[ Velocity, params.strength ]] -- object.Position
    store.object.count = 1
    out.addForce(object, vec2(params.force * object.Mass.value, 0))
  end,
})"),
              "2: the interaction has no description\n"
              "3: 'Velocity' in 'reads' is never read\n"
              "6: the parameter 'strength' has no effect\n"
              "6: the parameter 'strength' has no description for players\n"
              "6: the parameter 'strength' has no range, so players get no slider\n"
              "7: 'unused' in 'store' is never used\n");
}

TEST(Lint, FindsNothingInAScriptThatUsesWhatItDeclares) {
    EXPECT_EQ(lintOf(R"(return interaction {
  name = "Dynamics <- Test", calls = "Dynamics", text = "Pushes -- what \" is near.",
  reads = { "Position" }, attached = true,
  pairs = { first = { "Position" }, second = { "Position" }, within = "reach" },
  params = { reach = { default = 1, min = 0, max = 2, unit = "m", text = "How far" } },
  apply = function(a, b, params, out) out.addForce(b, b.Position.value - a.Position.value) end,
})"),
              "");
}

} // namespace
} // namespace trembler::lua
