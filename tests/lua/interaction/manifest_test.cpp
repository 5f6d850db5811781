#include "lua/binding/script.hpp"
#include "lua/interaction/manifest.hpp"
#include "puzzle/data/effects.hpp"

#include <gtest/gtest.h>

namespace trembler::lua {
namespace {

std::string const good = R"(return interaction {
  name = "Dynamics <- Wind",
  text = "Blows.",
  calls = "Dynamics",
  reads = { "Position", "Velocity", "Mass" },
  each = { "Mass" },
  params = {
    speed = { default = 8, min = 0, max = 60, unit = "m/s", text = "How hard it blows" },
    towards = { default = vec2(1, 0) },
    mode = { default = "calm", choices = { "calm", "stormy" } },
  },
  store = { object = { seen = 0, last = vec2(0, 0) }, script = { total = 0, on = false } },
  limits = { instructions = 50000 },
  apply = function(object, params, out) end,
}
)";

// All that is wrong, one line each, with places.
std::string problemsOf(std::string const& source) {
    Problems problems;
    Manifest manifest = readManifest(source, "wind.lua", problems);
    if (problems.empty()) {
        Registry registry;
        registerEffects(registry);
        (void)declare(std::move(manifest), "wind", Vocabulary(registry), problems);
    }
    try {
        problems.throwIfAny();
    } catch (InputError const& error) {
        std::string all;
        for (Diagnostic const& diagnostic : error.diagnostics()) {
            all += diagnostic.print() + "\n";
        }
        return all;
    }
    return "";
}

std::string with(std::string const& from, std::string const& to) {
    std::string changed = good;
    changed.replace(changed.find(from), from.size(), to);
    return changed;
}

TEST(Manifest, IsReadWhole) {
    Problems problems;
    Manifest const manifest = readManifest(good, "wind.lua", problems);
    ASSERT_TRUE(problems.empty()) << problemsOf(good);
    EXPECT_EQ(manifest.name, "Dynamics <- Wind");
    EXPECT_EQ(manifest.calls, "Dynamics");
    EXPECT_EQ(manifest.reads, (std::vector<std::string>{"Position", "Velocity", "Mass"}));
    EXPECT_EQ(manifest.application, Application::each);
    ASSERT_EQ(manifest.parameters.size(), 3U);
    Parameter const* const speed = manifest.parameter("speed");
    ASSERT_NE(speed, nullptr);
    EXPECT_EQ(std::get<double>(speed->initial), 8);
    EXPECT_EQ(speed->maximum, 60);
    EXPECT_EQ(speed->unit, "m/s");
    EXPECT_EQ(std::get<Vec2>(manifest.parameter("towards")->initial).x, 1);
    EXPECT_EQ(manifest.objectStore.size(), 2U);
    EXPECT_EQ(manifest.scriptStore.size(), 2U);
    EXPECT_EQ(manifest.limits.instructions, 50000U);
    EXPECT_EQ(problemsOf(good), "");
}

TEST(Manifest, ComplainsWithFileAndLineAndASuggestion) {
    auto const expect = [](std::string const& source, std::string const& part) {
        std::string const problems = problemsOf(source);
        EXPECT_NE(problems.find(part), std::string::npos) << "got: " << problems << "wanted: " << part;
    };
    expect(with("\"Position\"", "\"Positon\""),
           "wind.lua:5:14: there is no property 'Positon' (did you mean 'Position'?)");
    expect(with("calls = \"Dynamics\"", "calls = \"Dynamic\""),
           "begins with \"Dynamic <- \", or calls = \"Dynamics\"");
    expect(with("Dynamics <- Wind", "Wind"),
           "wind.lua:2:3: the name 'Wind' does not state what is connected");
    expect(with("reads =", "raeds ="), "wind.lua:5:3: unknown key 'raeds' (did you mean 'reads'?)");
    expect(with("default = 8", "default = 80"),
           "the default of parameter 'speed' is not between min and max");
    expect(with("\"calm\", choices", "\"wild\", choices"), "'calm' or 'stormy'");
    expect(with("each = { \"Mass\" },", ""), "the objects to which the script is applied are not stated");
    expect(with("each = { \"Mass\" },", "each = {},"), "'each' selects every object");
    expect(with("apply = function(object, params, out) end,", ""), "'apply' is missing");
    expect(with("instructions = 50000", "instructions = 5e9"), "the limit 'instructions' is too large");
    expect(with("function(object", "function(object, 3"), "wind.lua:14:28:");
    expect(with("default = 8", "default 8"), "wind.lua:8:23: '}' expected near '8'");
    expect("return interaction {\n\tname = \"a\" text = \"b\" }", "wind.lua:2:13: ");
    // LuaJIT's messages quote the script, not the counters that are put into it.
    expect("for i = 1, 2 do do do\n  return\nend end end end", "wind.lua:3:");
    expect("local x = nothing.at.all\n" + good, "wind.lua:1:1: there is no 'nothing'");
    expect("return 3", "the script returns no interaction");
    expect("x = 1\n" + good, "'x' is not declared");
    expect("while true do end", "more than its");
    // A resolver property without described fields.
    expect(with("\"Position\"", "\"graph_changes\""),
           "the property 'graph_changes' has no fields that a script could read");
    expect(with("each = { \"Mass\" }", "each = { \"contacts\" }"), "no object has 'contacts'");
}

TEST(Manifest, NeverReadsCompiledCode) {
    EXPECT_NE(problemsOf("\x1bLJ\x02").find("this is compiled code"), std::string::npos);
}

} // namespace
} // namespace trembler::lua
