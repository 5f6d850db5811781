// No script gets an address, or a text above its limit, by any route, and all runs give it the same texts.
#include "lua/sandbox/sandbox.hpp"
#include "lua/sandbox/stack_values.hpp"
#include "tests/lua/sandbox/whole/text_attacks.hpp"
#include "tests/lua/support/text_checks.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <lua.hpp>
#include <memory>
#include <set>
#include <vector>

namespace trembler::lua {
namespace {

constexpr std::string_view helpers =
    "local function try(...) return { pcall(...) } end local function xtry(...) return { xpcall(...) } end "
    "local function resume(...) return { coroutine.resume(...) } end ";

std::string chunkOf(TextAttack const& attack) {
    std::string text(helpers);
    text += attack.chunk;
    for (std::size_t at = text.find("NAME"); at != std::string::npos; at = text.find("NAME")) {
        text.replace(at, 4, std::string(5000, 'n'));
    }
    return text;
}

/// Adds every text at an index of the stack, and in the tables there.
void gather(lua_State* L, int index, int depth, std::vector<std::string>& texts) {
    if (lua_type(L, index) == LUA_TSTRING) {
        texts.push_back(textAt(L, index));
    } else if (lua_type(L, index) == LUA_TTABLE && depth < 3) {
        for (std::string const& key : stringKeys(L, index)) {
            texts.push_back(key);
            lua_pushlstring(L, key.data(), key.size());
            lua_rawget(L, index);
            gather(L, lua_gettop(L), depth + 1, texts);
            lua_pop(L, 1);
        }
        for (int i = 1; i <= static_cast<int>(lua_objlen(L, index)); ++i) {
            lua_rawgeti(L, index, i);
            gather(L, lua_gettop(L), depth + 1, texts);
            lua_pop(L, 1);
        }
    }
}

/// What a script gets to see, and what the player does.
struct Seen {
    std::vector<std::string> texts; ///< returned
    std::vector<std::string> lines; ///< logged
    std::string message;
    std::string traceback;
    bool limit = false;

    [[nodiscard]] std::string all() const {
        std::string joined;
        for (auto const* list : {&texts, &lines}) {
            for (std::string const& text : *list) {
                joined += text + "\n";
            }
        }
        return joined + message + "\n" + traceback;
    }
};

Seen seenBy(std::string const& chunk, Trust trust, int turns = 1) {
    ScriptLimits limits;
    limits.instructions = 1'000'000;
    limits.logLines = 100;
    Sandbox sandbox(limits, trust);
    Seen seen;
    if (auto const refused = sandbox.load(chunk, "attack.lua")) {
        seen.message = refused->message;
        return seen;
    }
    for (int turn = 0; turn < turns; ++turn) {
        seen = {};
        sandbox.onLog = [&](std::string const& line) { seen.lines.push_back(line); };
        auto const failed = sandbox.turn(1, [&](lua_State* L) {
            sandbox.pushChunk(L);
            sandbox.callScript(L, 0, LUA_MULTRET);
            for (int i = 1, last = lua_gettop(L); i <= last; ++i) {
                gather(L, i, 0, seen.texts);
            }
        });
        if (failed) {
            seen.message = failed->message;
            seen.traceback = failed->traceback;
            seen.limit = failed->limit;
        }
    }
    return seen;
}

class TextDoor : public testing::TestWithParam<TextAttack> {};

TEST_P(TextDoor, LetsNoAddressAndNoLongTextThrough) {
    std::string const chunk = chunkOf(GetParam());
    Seen const first = seenBy(chunk, Trust::untrusted);
    EXPECT_FALSE(first.texts.empty() && first.lines.empty() && first.message.empty())
        << "the attack says nothing";
    for (std::string const& text : first.texts) {
        expectHarmless(text);
    }
    for (std::string const& line : first.lines) {
        expectHarmless(line, longestLogLine);
    }
    expectHarmless(first.message, 1100);
    expectHarmless(first.traceback, 2000);
}

TEST_P(TextDoor, GivesTheSameInAllRuns) {
    std::string const chunk = chunkOf(GetParam());
    Seen const first = seenBy(chunk, Trust::untrusted);
    std::vector<std::unique_ptr<char[]>> moved; // so that other addresses are in use
    for (Trust const trust : {Trust::untrusted, Trust::trusted, Trust::trusted}) {
        moved.push_back(std::make_unique<char[]>(1000 + 777 * moved.size()));
        Seen const other = seenBy(chunk, trust, 3);
        bool const memory = first.message.find("memory") != std::string::npos; // its limits differ
        if (!memory) {
            EXPECT_EQ(other.all(), first.all());
            EXPECT_EQ(other.limit, first.limit);
        }
        expectHarmless(other.message, 1100);
        expectHarmless(other.traceback, 2000);
    }
}

INSTANTIATE_TEST_SUITE_P(Attacks, TextDoor, testing::ValuesIn(textAttacks().begin(), textAttacks().end()),
                         [](auto const& info) {
                             std::string name(info.param.name);
                             for (char& c : name) {
                                 c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
                             }
                             return name;
                         });

TEST(TextAttacks, AreMoreThanAHundredAndAllDiffer) {
    std::set<std::string_view> chunks;
    for (TextAttack const& attack : textAttacks()) {
        EXPECT_TRUE(chunks.insert(attack.chunk).second) << attack.name;
    }
    EXPECT_GE(chunks.size(), 100U);
}

/// The texts of all attacks, as one number.
std::size_t textsOfAll() {
    std::string all;
    for (TextAttack const& attack : textAttacks()) {
        all += seenBy(chunkOf(attack), Trust::untrusted).all();
    }
    return std::hash<std::string>{}(all);
}

TEST(TextDoorProcess, PrintsItsTexts) {
    std::printf("texts %zu\n", textsOfAll());
}

TEST(TextDoorProcess, GivesTheSameTextsAsAnotherOne) {
    std::string const self = std::filesystem::read_symlink("/proc/self/exe").string();
    // Without the variables that share the tests out among processes, or another share prints nothing.
    std::string const command = "env -u GTEST_TOTAL_SHARDS -u GTEST_SHARD_INDEX MALLOC_PERTURB_=42 "
                                "MALLOC_TOP_PAD_=1234567 '" +
                                self + "' --gtest_filter=TextDoorProcess.PrintsItsTexts 2>&1";
    std::string output;
    FILE* const pipe = popen(command.c_str(), "r");
    ASSERT_NE(pipe, nullptr);
    std::array<char, 4096> buffer{};
    while (std::size_t const got = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
        output.append(buffer.data(), got);
    }
    EXPECT_EQ(pclose(pipe), 0);
    EXPECT_NE(output.find("texts " + std::to_string(textsOfAll()) + "\n"), std::string::npos) << output;
}

// A loop that is long enough is compiled in a trusted script: its texts are those of the interpreter.
TEST(TextDoor, IsTheSameInCompiledCode) {
    std::string const chunk =
        "local last, w = '', vec2(0, 0) for i = 1, 300 do\n"
        "  local v = vec2(i / 7, -i * 1e300) w.x = w.x + v.x\n"
        "  pcall(function() w.y = {} end)\n"
        "  last = tostring(v) .. tostring(w) .. i / 3 .. string.format('%d %s %.3g', i, v, i * 0.1)\n"
        "  if i % 50 == 0 then log(last, {}, print, -i * 0) end\nend return last";
    Seen const interpreted = seenBy(chunk, Trust::untrusted);
    EXPECT_EQ(interpreted.message, "");
    EXPECT_EQ(interpreted.lines.size(), 6U);
    EXPECT_EQ(seenBy(chunk, Trust::trusted, 3).all(), interpreted.all());
}

} // namespace
} // namespace trembler::lua
