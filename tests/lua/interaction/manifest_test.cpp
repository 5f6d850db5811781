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

TEST(Manifest, HasItsTextsInOneLine) {
    for (auto const& [from, to] :
         {std::pair{"\"Dynamics <- Wind\"", R"("Dynamics <- Wind\nforged")"},
          std::pair{"\"Blows.\"", R"("Blows.\rforged")"}, std::pair{"\"m/s\"", R"("m/s\0")"},
          std::pair{"\"How hard it blows\"", R"("How hard\127it blows")"}}) {
        std::string const problems = problemsOf(with(from, to));
        EXPECT_NE(problems.find("has a line end or another control character; expected one line"),
                  std::string::npos)
            << to << "\n"
            << problems;
    }
    EXPECT_EQ(problemsOf(with("\"Blows.\"", "\"Bläst – stark.\"")), "");
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
    expect(with("instructions = 50000", "instructions = 5e9"),
           "wind.lua:13:14: 'limits.instructions' cannot be 5000000000; expected a whole number from 0 to "
           "200000");
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

TEST(Manifest, StatesLimitsInWholeNumbersBetweenTheLeastAndTheMost) {
    struct Case {
        std::string stated;
        std::string message;
    };
    std::vector<Case> const cases{
        {"calls = -5", "13:14: 'limits.calls' cannot be -5; expected a whole number from 0 to 1000"},
        {"calls = 1.5", "'limits.calls' cannot be 1.5; expected a whole number from 0 to 1000"},
        {"calls = 0/0", "'limits.calls' cannot be nan; expected"},
        {"calls = -(0/0)", "'limits.calls' cannot be nan; expected"},
        {"calls = true", "'limits.calls' cannot be true or false; expected"},
        {"calls = {}", "'limits.calls' cannot be a table; expected"},
        {"log_lines = \"5\"", "'limits.log_lines' cannot be a text; expected a whole number from 0 to 100"},
        {"memory = -1", "'limits.memory' cannot be -1; expected a whole number from 524288 to 16777216"},
        {"memory = 1000", "'limits.memory' cannot be 1000; expected a whole number from 524288 to 16777216"},
    };
    for (Case const& one : cases) {
        std::string const said = problemsOf(with("instructions = 50000", one.stated));
        EXPECT_NE(said.find(one.message), std::string::npos) << said;
    }
    EXPECT_EQ(problemsOf(with("instructions = 50000", "memory = 524288, calls = 0")), "");
    EXPECT_NE(
        problemsOf(with("limits = { instructions = 50000 }", "limits = 5")).find("'limits' is no table"),
        std::string::npos);
}

TEST(Manifest, SpeaksOfChoicesAsChoices) {
    std::string const twice = problemsOf(with("\"calm\", \"stormy\" }", "\"calm\", \"calm\" }"));
    EXPECT_NE(twice.find("'calm' is repeated; expected every choice once"), std::string::npos) << twice;
    std::string const numbers = problemsOf(with("choices = { \"calm\", \"stormy\" }", "choices = { 1 }"));
    EXPECT_NE(
        numbers.find("'choices' is no list of at most 50 texts; expected choices = { \"calm\", \"stormy\" }"),
        std::string::npos)
        << numbers;
}

TEST(Manifest, HasAtMost32FieldsInAStore) {
    auto const fields = [](int count) {
        std::string all;
        for (int i = 0; i < count; ++i) {
            all += "f" + std::to_string(i) + " = 0, ";
        }
        return with("seen = 0, last = vec2(0, 0)", all);
    };
    EXPECT_EQ(problemsOf(fields(32)), "");
    EXPECT_NE(problemsOf(fields(33)).find("'object' in 'store' has 33 fields; expected at most 32"),
              std::string::npos);
}

TEST(Manifest, NeverReadsCompiledCode) {
    EXPECT_NE(problemsOf("\x1bLJ\x02").find("this is compiled code"), std::string::npos);
}

} // namespace
} // namespace trembler::lua
