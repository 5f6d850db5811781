// Control characters in a level, a name or an argument never reach the terminal.
#include "tests/game/app/program.hpp"

#include <nlohmann/json.hpp>

namespace trembler::test {
namespace {

using nlohmann::json;

class Words : public InAFolder {};

// A sequence that clears the screen, a C1 control character that ends a string, and a reversal of the writing
// direction.
std::string const evil = "e\x1b[2Jv\xC2\x9Bi\xE2\x80\xAEl\xE2\x81\xA6\x7F";

/// Whether a terminal shows this unchanged: no control characters except line feeds and tabs, and none that
/// reverses the writing direction. Compares bytes, so it shares no code with the program.
bool isHarmless(std::string const& text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        auto const byte = [&](std::size_t at) {
            return at < text.size() ? static_cast<unsigned char>(text[at]) : 0U;
        };
        bool const control = (byte(i) < 0x20 && text[i] != '\n' && text[i] != '\t') || byte(i) == 0x7F;
        bool const c1 = byte(i) == 0xC2 && byte(i + 1) >= 0x80 && byte(i + 1) <= 0x9F;
        bool const turns =
            byte(i) == 0xE2 && ((byte(i + 1) == 0x80 && byte(i + 2) >= 0xAA && byte(i + 2) <= 0xAE) ||
                                (byte(i + 1) == 0x81 && byte(i + 2) >= 0xA6 && byte(i + 2) <= 0xA9));
        if (control || c1 || turns) {
            return false;
        }
    }
    return true;
}

json anyLevel() {
    return json::parse(contentsOf(levelFile("experiments/1-switched-electromagnet.json")));
}

void expectHarmless(Ran const& ran, std::string const& what) {
    EXPECT_TRUE(isHarmless(ran.out)) << what << "\n" << json(ran.out).dump(-1, ' ', true);
    EXPECT_TRUE(isHarmless(ran.err)) << what << "\n" << json(ran.err).dump(-1, ' ', true);
    EXPECT_FALSE(ran.out.empty() && ran.err.empty()) << what;
}

TEST_F(Words, OfALevelAreHarmless) {
    std::vector<std::pair<std::string, json>> levels;
    json made = anyLevel();
    made["goals"] = {{"moved", {{"object", "metal object"}, {"by", 1}}}, {"text", evil}};
    levels.emplace_back("a goal's text", made);
    made = anyLevel();
    made[evil] = 1;
    levels.emplace_back("an unknown key", made);
    made = anyLevel();
    made["title"] = evil;
    levels.emplace_back("the title", made);
    made = anyLevel();
    made["objects"][0]["part"] = evil.substr(5);
    levels.emplace_back("a part", made);
    made = anyLevel();
    made["objects"][0]["name"] = "e\xC2\x9Bv\xE2\x80\xAEil"; // without C0 characters, which no name may have
    levels.emplace_back("a name", made);
    made = anyLevel();
    made["solutions"] = {{{"name", "e\xC2\x9Bvil"}, {"expect", "solved"}, {"frames", 1}}};
    levels.emplace_back("a solution", made);
    for (auto const& [what, level] : levels) {
        write(at("level.json"), level.dump());
        expectHarmless(runProgram({"run", at("level.json"), "--frames", "300"}), what);
        expectHarmless(runProgram({"run", at("level.json"), "--frames", "300", "--json"}), what);
        expectHarmless(runProgram({"run", at("level.json"), "--frames", "300", "--trace", "-"}), what);
        expectHarmless(runProgram({"run", at("level.json"), "--frames", "1", "--record", "-"}), what);
    }
    made = anyLevel();
    made["solutions"] = {{{"name", "e\xC2\x9Bvil"}, {"expect", "solved"}, {"frames", 1}}};
    write(at("level.json"), made.dump());
    expectHarmless(runProgram({"verify", at("level.json")}), "verify");
}

TEST_F(Words, OfArgumentsAreHarmless) {
    std::string const good = InAFolder::level();
    for (auto const& arguments : std::vector<std::vector<std::string>>{
             {evil},
             {"run", evil},
             {"run", good, evil},
             {"run", good, "--" + evil},
             {"run", good, "--frames", evil},
             {"run", good, "--detail", evil},
             {"run", good, "--detail", evil + "=1"},
             {"run", good, "--period", evil + "=1"},
             {"run", good, "--solution", evil},
             {"run", good, "--trace", "/" + evil + "/file"},
             {"run", good, "--sound", evil},
             {"screenshot", good, "--out", at("picture.png"), "--size", evil},
             {"accuracy", evil},
             {"verify", evil},
             {"run", std::string("\x9b\xff\xc2 no UTF-8")}}) {
        Ran const ran = runProgram(arguments);
        EXPECT_EQ(ran.status == 0, false);
        expectHarmless(ran, arguments.back());
    }
}

TEST_F(Words, InJsonKeepTheirMeaning) {
    json made = anyLevel();
    std::string const name = "e\xC2\x9Bv\xE2\x80\xAEil \xC3\xA4"; // with an a umlaut
    made["goals"] = {{"moved", {{"object", "metal object"}, {"by", 1}}}, {"text", name}};
    write(at("level.json"), made.dump());
    Ran const ran = runProgram({"run", at("level.json"), "--frames", "1", "--json"});
    EXPECT_EQ(json::parse(ran.out)["goals"][0]["text"], name);
    EXPECT_NE(ran.out.find("\\u009b"), std::string::npos);
    EXPECT_NE(ran.out.find("\xC3\xA4"), std::string::npos) << "harmless characters stay readable";
}

} // namespace
} // namespace trembler::test
