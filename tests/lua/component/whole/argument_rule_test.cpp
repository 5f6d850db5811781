// One rule for all arguments: every call of every resolver and every function of the host refuses an argument
// of the wrong kind, one that is missing and one too many, with the place in the script, the name of what was
// called and what was expected. Trusted scripts get the same texts.
#include "lua/binding/call_arguments.hpp"
#include "lua/sandbox/prelude/signatures.hpp"
#include "puzzle/data/game_data.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/lua/support/script_world.hpp"
#include "tests/lua/support/text_checks.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>

namespace trembler::lua {
namespace {

/// A call in Lua, and whether it is to be refused.
struct RuleCase {
    std::string code;
    bool refused = true;
};

/// The cases of one function, and how its messages name it.
struct RuleCases {
    std::string role; ///< that the script calls
    std::string named;
    std::vector<RuleCase> cases;
};

struct RuleValue {
    std::string_view code;
    std::string_view kind;
};
constexpr std::array<RuleValue, 15> ruleValues{{
    {"nil", "nil"},
    {"true", "boolean"},
    {"1", "number"},
    {"'text'", "string"},
    {"{}", "table"},
    {"log", "function"},
    {"coroutine.create(log)", "coroutine"},
    {"vec2(1, 2)", "vector"},
    {"object", "object"},
    {"world", "world"},
    {"params", "host"},
    {"out", "host"},
    {"store", "host"},
    {"frame", "host"},
    {"math", "host"},
}};

bool accepts(CallDescription const& call, FieldPlace const& place, std::string_view kind) {
    if (kind == "nil") {
        return !place.info.required;
    }
    switch (place.kind) {
    case FieldKind::boolean:
        return kind == "boolean";
    case FieldKind::vector:
        return kind == "vector";
    case FieldKind::object:
        return kind == "object" || (kind == "world" && takesWorld(call, place));
    case FieldKind::choice:
    case FieldKind::part:
        return false; // a text that is no name of one
    default:
        return kind == "number";
    }
}

std::string fitting(FieldPlace const& place) {
    double const number =
        std::clamp(1.0, place.info.minimum, std::max(place.info.minimum, place.info.maximum));
    switch (place.kind) {
    case FieldKind::boolean:
        return "true";
    case FieldKind::vector:
        return "vec2(1, 1)";
    case FieldKind::object:
        return "object";
    case FieldKind::choice:
        return fmt::format("'{}'", place.choices.front());
    case FieldKind::part:
        return "'rubber ball'";
    default:
        return fmt::format("{}", std::ceil(number));
    }
}

std::string joinedWith(std::vector<std::string> const& arguments) {
    std::string all;
    for (std::string const& argument : arguments) {
        all += (all.empty() ? "" : ", ") + argument;
    }
    return all;
}

RuleCases casesOf(RoleInfo const& role, CallDescription const& call) {
    RuleCases made{.role = std::string(role.name), .named = std::string(call.text.name), .cases = {}};
    std::vector<std::string> right;
    std::vector<std::string> named;
    for (FieldPlace const& place : call.arguments) {
        right.push_back(fitting(place));
        named.push_back(fmt::format("{} = {}", place.info.key, right.back()));
    }
    auto const stated = [&](std::vector<std::string> const& arguments, bool refused) {
        made.cases.push_back({fmt::format("out.{}({})", made.named, joinedWith(arguments)), refused});
    };
    auto const byName = [&](std::vector<std::string> const& arguments, bool refused) {
        if (call.arguments.size() > 1) {
            made.cases.push_back({fmt::format("out.{}{{ {} }}", made.named, joinedWith(arguments)), refused});
        }
    };
    stated(right, false);
    byName(named, false);
    for (std::size_t i = 0; i < right.size(); ++i) {
        FieldPlace const& place = call.arguments[i];
        for (RuleValue const& value : ruleValues) {
            bool const accepted = accepts(call, place, value.kind);
            // A number and the next argument could be a vector as two numbers.
            bool const half =
                place.kind == FieldKind::vector && value.kind == "number" && i + 1 < right.size();
            bool const out = value.kind == "number" && accepted; // it may be out of range
            if (half || out) {
                continue;
            }
            auto wrong = right;
            wrong[i] = value.code;
            stated(wrong, !accepted);
            auto wrongNamed = named;
            wrongNamed[i] = fmt::format("{} = {}", place.info.key, value.code);
            byName(wrongNamed, !accepted);
        }
        if (place.kind == FieldKind::vector) {
            auto wrong = right;
            wrong[i] = "vec2(0 / 0, 0)";
            stated(wrong, true);
        } else if (place.kind == FieldKind::number) {
            auto wrong = right;
            wrong[i] = "1 / 0";
            stated(wrong, true);
        }
    }
    for (std::vector<std::string> const& more : {std::vector<std::string>{"1"},
                                                 {"object"},
                                                 {"nil", "1"},
                                                 {"nil", "nil", "nil", "{}"},
                                                 {"1", "1", "1", "1"}}) {
        auto wrong = right;
        wrong.insert(wrong.end(), more.begin(), more.end());
        stated(wrong, true);
    }
    auto nothingMore = right;
    nothingMore.insert(nothingMore.end(), {"nil", "nil"});
    stated(nothingMore, false);
    stated({}, std::any_of(call.arguments.begin(), call.arguments.end(),
                           [](FieldPlace const& place) { return place.info.required; }));
    for (std::string const extra : {"nothing_like_it = 1", "1", "[{}] = 1"}) {
        auto wrong = named;
        wrong.push_back(extra);
        byName(wrong, true);
    }
    return made;
}

bool accepts(ArgumentKind wanted, std::string_view kind) {
    switch (wanted) {
    case ArgumentKind::any:
        return true;
    case ArgumentKind::number:
        return kind == "number";
    case ArgumentKind::text:
        return kind == "string";
    case ArgumentKind::function:
        return kind == "function";
    case ArgumentKind::callable:
        return kind != "nil" && kind != "boolean" && kind != "number" && kind != "string" &&
               kind != "coroutine";
    case ArgumentKind::coroutine:
        return kind == "coroutine";
    case ArgumentKind::table:
    case ArgumentKind::listed:
        return kind == "table";
    case ArgumentKind::looked:
        return kind == "table" || kind == "vector";
    case ArgumentKind::vector:
        return kind == "vector";
    case ArgumentKind::index:
        return kind == "number";
    case ArgumentKind::object:
        return kind == "object";
    }
    return false;
}

std::string fitting(ArgumentKind kind) {
    for (RuleValue const& value : ruleValues) {
        if (value.kind != "nil" && accepts(kind, value.kind)) {
            return std::string(value.code);
        }
    }
    return "true";
}

RuleCases casesOf(HostFunction const& function) {
    bool const method = function.name.starts_with("vec2:");
    std::string const member(method ? function.name.substr(5) : function.name);
    std::string const code = method ? "vec2(1, 2)." + member : member;
    RuleCases made{.role = "Frame", .named = method ? "v:" + member : member, .cases = {}};
    std::vector<std::string> right;
    for (HostParameter const& parameter : function.parameters) {
        right.push_back(fitting(parameter.kind));
    }
    auto const add = [&](std::vector<std::string> const& arguments, bool refused) {
        // What a value of the right kind does is not this test's matter; yielding from here is impossible.
        if (refused || (function.name != "error" && function.name != "coroutine.yield")) {
            made.cases.push_back({fmt::format("{}({})", code, joinedWith(arguments)), refused});
        }
    };
    for (std::size_t i = 0; i < right.size(); ++i) {
        HostParameter const& parameter = function.parameters[i];
        for (RuleValue const& value : ruleValues) {
            if (accepts(parameter.kind, value.kind) || (value.kind == "nil" && parameter.optional)) {
                continue;
            }
            auto wrong = right;
            wrong[i] = value.code;
            add(wrong, true);
        }
        if (!parameter.optional) {
            add({right.begin(), right.begin() + static_cast<std::ptrdiff_t>(i)}, true);
        }
    }
    if (!function.more) {
        for (std::vector<std::string> const& more :
             {std::vector<std::string>{"1"}, {"nil", "1"}, {"1", "{}", "nil"}}) {
            auto wrong = right;
            wrong.insert(wrong.end(), more.begin(), more.end());
            add(wrong, true);
        }
    } else if (function.moreOf != ArgumentKind::any) {
        for (RuleValue const& value : ruleValues) {
            if (value.kind != "nil" && !accepts(function.moreOf, value.kind)) {
                auto wrong = right;
                wrong.insert(wrong.end(), {fitting(function.moreOf), std::string(value.code)});
                add(wrong, true);
            }
        }
    }
    return made;
}

/// A script that makes the calls one after the other, each in a line of its own, in its first turn.
std::string scriptOf(RuleCases const& one, std::size_t first, std::size_t last, std::size_t number) {
    std::string text = fmt::format(
        "return interaction {{ name = '{0} <- Rule {1}', calls = '{0}', reads = {{ 'Position' }}, "
        "each = {{ 'Position' }}, store = {{ script = {{ done = false }} }}, limits = {{ "
        "instructions = 200000, calls = 1000, creations = 200, log_lines = 100, memory = 16777216 }}, "
        "apply = function(object, params, out, store, frame) if store.script.done then return end "
        "store.script.done = true\n",
        one.role, number);
    for (std::size_t i = first; i < last; ++i) {
        text += fmt::format("log(select(2, pcall(function() {}{} return 'accepted' end)))\n",
                            one.cases[i].code.starts_with("out.") ? "" : "local _ = ", one.cases[i].code);
    }
    return text + "end }";
}

/// The lines that each script logs in a world with objects of all kinds.
std::map<std::string, std::vector<std::string>> linesOf(std::vector<std::string> const& sources,
                                                        Trust trust) {
    static GameData const plain;
    ScriptedGame const game(sources, trust);
    auto const file = std::filesystem::path(TREMBLER_SOURCE_DIR) / "tests/lua/reference/world.json";
    auto const world = buildWorld(game.registry, loadLevel(game.registry, file), plain.parts);
    world->step();
    std::map<std::string, std::vector<std::string>> lines;
    for (ScriptMessage const& message : game.log->take()) {
        EXPECT_FALSE(message.error) << message.script << ": " << message.text;
        lines[message.script].push_back(message.text);
    }
    return lines;
}

void expectTheRule(std::vector<RuleCases> const& all) {
    struct Part {
        RuleCases const* of = nullptr;
        std::size_t first = 0;
        std::size_t last = 0;
        std::string name;
    };
    constexpr std::size_t most = 80; // of one script: its log has a limit
    constexpr std::size_t together = 8;
    std::vector<Part> parts;
    std::vector<std::string> sources;
    for (RuleCases const& one : all) {
        for (std::size_t first = 0; first < one.cases.size(); first += most) {
            std::size_t const last = std::min(first + most, one.cases.size());
            parts.push_back({&one, first, last, fmt::format("{} <- Rule {}", one.role, sources.size())});
            sources.push_back(scriptOf(one, first, last, sources.size()));
        }
    }
    for (std::size_t begin = 0; begin < parts.size(); begin += together) {
        std::size_t const end = std::min(begin + together, parts.size());
        std::vector<std::string> const these(sources.begin() + static_cast<std::ptrdiff_t>(begin),
                                             sources.begin() + static_cast<std::ptrdiff_t>(end));
        auto const lines = linesOf(these, Trust::untrusted);
        EXPECT_EQ(linesOf(these, Trust::trusted), lines) << "trusted scripts get other texts";
        for (std::size_t p = begin; p < end; ++p) {
            Part const& part = parts[p];
            auto const said = lines.find(part.name);
            ASSERT_NE(said, lines.end()) << part.name << ": " << sources[p];
            ASSERT_EQ(said->second.size(), part.last - part.first) << sources[p];
            for (std::size_t i = part.first; i < part.last; ++i) {
                RuleCase const& one = part.of->cases[i];
                std::string const& line = said->second[i - part.first];
                SCOPED_TRACE(one.code + "\n  " + line);
                expectHarmless(line, longestLogLine);
                if (!one.refused) {
                    EXPECT_EQ(line, "accepted");
                    continue;
                }
                std::string const place = fmt::format("script{}.lua:{}: ", p - begin + 1, i - part.first + 2);
                EXPECT_TRUE(line.starts_with(place)) << place;
                EXPECT_NE(line.find(part.of->named), std::string::npos);
                EXPECT_NE(line.find("; expected "), std::string::npos);
            }
        }
    }
}

TEST(ArgumentRule, HoldsForEveryCallOfEveryResolver) {
    Registry registry;
    registerEffects(registry);
    Vocabulary const vocabulary(registry);
    std::vector<RuleCases> all;
    std::size_t worlds = 0;
    for (std::string const& name : vocabulary.roleNames()) {
        for (CallDescription const& call : vocabulary.role(name)->calls) {
            all.push_back(casesOf(*vocabulary.role(name), call));
            for (FieldPlace const& place : call.arguments) {
                worlds += takesWorld(call, place) ? 1 : 0;
            }
        }
    }
    EXPECT_GT(all.size(), 20U);
    EXPECT_EQ(worlds, 1U) << "arguments for which the world counts as an object";
    expectTheRule(all);
}

TEST(ArgumentRule, HoldsForEveryFunctionOfTheHost) {
    std::vector<RuleCases> all;
    for (HostFunction const& function : hostFunctions()) {
        RuleCases cases = casesOf(function);
        if (!cases.cases.empty()) { // log() takes everything
            all.push_back(std::move(cases));
        }
    }
    EXPECT_GT(all.size(), 55U);
    expectTheRule(all);
}

// An object may be the world itself, where a script is applied to what has gravity.
TEST(ArgumentRule, RefusesTheWorldAlsoWhereTheScriptIsAppliedToIt) {
    for (Trust const trust : {Trust::untrusted, Trust::trusted}) {
        ScriptedGame const game(
            {"return interaction { name = 'Population <- Test', calls = 'Population', reads = { 'Gravity' "
             "},\n"
             "each = { 'Gravity' }, apply = function(object, params, out)\n  out.destroyObject(object) end }",
             "return interaction { name = 'Dynamics <- Test', calls = 'Dynamics', reads = { 'Gravity' },\n"
             "each = { 'Gravity' }, apply = function(object, params, out)\n  out.addForce(object, 1, 2) end "
             "}"},
            trust);
        World world(game.registry);
        Store& store = world.store();
        store.column<GravityField>().set(store.create("world"), {{0, -10}});
        addBox(store, "box", {0, 0});
        world.start();
        world.step();
        world.step();
        EXPECT_EQ(
            game.messages(),
            "error: script1.lua:3: argument 'object' of destroyObject is the world; expected an object\n"
            "error: script2.lua:3: argument 'object' of addForce is the world; expected an object\n");
        EXPECT_TRUE(store.find("world").valid());
    }
}

} // namespace
} // namespace trembler::lua
