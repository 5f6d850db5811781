// Every command that takes a level refuses the same levels, with the same words: a mistake in a section that
// a command does not need is none the less a mistake, and a player or author learns of it at once.
#include "game/app/program.hpp"
#include "puzzle/checks/checked_level.hpp"
#include "puzzle/data/game_data.hpp"
#include "puzzle/solutions/verify.hpp"
#include "tests/game/app/program.hpp"
#ifndef TREMBLER_HEADLESS
#include "game/ui/app/play.hpp"
#endif

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <iostream>
#include <map>
#include <optional>
#include <random>
#include <sstream>
#include <unistd.h>
#include <utility>

namespace trembler::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct Said {
    int status = -1;
    std::string err;
};

/// Runs a command in this process, which is quicker, and reads what it prints.
Said said(std::vector<std::string> const& arguments) {
    std::ostringstream out;
    std::ostringstream err;
    std::streambuf* const outBefore = std::cout.rdbuf(out.rdbuf());
    std::streambuf* const errBefore = std::cerr.rdbuf(err.rdbuf());
    Request const request = requestFrom(arguments);
    int const status = request.work ? guarded(request.work) : request.status;
    std::cout.rdbuf(outBefore);
    std::cerr.rdbuf(errBefore);
    return {status, request.err + err.str()};
}

fs::path wholeLevel() {
    return levelFile("experiments/1-switched-electromagnet.json");
}

/// A TREMBLER_HOME with those parts only that the level names, and those that they consist of: each command
/// reads all parts, which would take nearly all of the time.
class HomeWithFewParts {
public:
    HomeWithFewParts() {
        if (char const* const stated = std::getenv("TREMBLER_HOME")) {
            before_ = stated;
        }
        fs::remove_all(folder_);
        fs::create_directories(folder_ / "levels");
        fs::path const copies = folder_ / "assets" / "parts";
        fs::create_directories(copies);
        std::map<std::string, fs::path> files; // by the name of the part
        for (auto const& entry : fs::directory_iterator(homeFolder() / "assets" / "parts")) {
            files[json::parse(contentsOf(entry.path())).at("name").get<std::string>()] = entry.path();
        }
        std::string all = contentsOf(wholeLevel());
        for (bool more = true; std::exchange(more, false);) {
            for (auto const& [name, file] : files) {
                if (all.find('"' + name + '"') != std::string::npos &&
                    !fs::exists(copies / file.filename())) {
                    fs::copy_file(file, copies / file.filename());
                    all += contentsOf(file);
                    more = true;
                }
            }
        }
        ::setenv("TREMBLER_HOME", folder_.c_str(), 1);
    }
    ~HomeWithFewParts() {
        if (before_) {
            ::setenv("TREMBLER_HOME", before_->c_str(), 1);
        } else {
            ::unsetenv("TREMBLER_HOME");
        }
        fs::remove_all(folder_);
    }
    HomeWithFewParts(HomeWithFewParts const&) = delete;
    HomeWithFewParts& operator=(HomeWithFewParts const&) = delete;

private:
    fs::path const folder_ = fs::path(testing::TempDir()) / ("few parts " + std::to_string(::getpid()));
    std::optional<std::string> before_;
};

class BadLevels : public InAFolder {
protected:
    /// A demonstration that has every section.
    static json whole() {
        json level = json::parse(contentsOf(wholeLevel()));
        for (char const* const section :
             {"goals", "task", "texts", "hints", "toolbox", "placing", "solutions"}) {
            EXPECT_TRUE(level.contains(section)) << section;
        }
        level["teaching"] = json::array({{{"place", "steel bar"}, {"at", {-1.8, 1.15}}}, {{"run", true}}});
        return level;
    }

    [[nodiscard]] std::vector<std::vector<std::string>> commands(std::string const& file) const {
        std::vector<std::vector<std::string>> all{{"run", file, "--frames", "1"},
                                                  {"why", file, "--frames", "1"},
                                                  {"report", file, "--runs", "0", "--drops", "0", "--brief"},
                                                  {"solve", file, "--runs", "1", "--frames", "1"}};
#ifndef TREMBLER_HEADLESS
        all.push_back({"screenshot", file, "--out", at("new.png")});
        all.push_back({"clip", file, "--out", at("new.webp"), "--seconds", "0.1"});
#endif
        return all;
    }

    /// The words with which a level is refused; empty if it is not.
    std::string refusal(std::string const& file) const {
        try {
            (void)loadPlayable(data.registry, data.parts, file);
            return "";
        } catch (InputError const& error) {
            std::string text;
            for (Diagnostic const& diagnostic : error.diagnostics()) {
                text += diagnostic.print() + "\n";
            }
            return text;
        }
    }

    /// Of all commands, or, to save time, of two, which differ from call to call.
    void expectTheSameOfAll(json const& level, std::string const& what,
                            std::optional<std::size_t> turn) const {
        std::string const file = at("level.json");
        write(file, level.dump(1));
        std::string const expected = refusal(file);
        ASSERT_NE(expected, "") << what;
        std::vector<std::vector<std::string>> tried = commands(file);
        if (turn) {
            std::size_t const count = tried.size();
            tried = {tried[*turn % count], tried[(*turn + 1 + *turn / count) % count]};
        }
        for (auto const& command : tried) {
            Said const ran = said(command);
            EXPECT_EQ(ran.status, 2) << command.front() << ": " << what;
            EXPECT_EQ(ran.err, expected) << command.front() << ": " << what;
        }
#ifndef TREMBLER_HEADLESS
        ui::PlayOptions options;
        options.level = file;
        std::ostringstream played; // what `play` does without a display; the window shows the words instead
        EXPECT_THROW((void)ui::playWithoutDisplay(data, options, played), InputError) << what;
#endif
        EXPECT_FALSE(verifyLevel(data, file).empty()) << what;
    }

    HomeWithFewParts const fewParts; // before the data
    GameData const data;
};

TEST_F(BadLevels, AreRefusedByAllCommandsWhateverSectionIsWrong) {
    std::vector<std::pair<std::string, json>> const wrong{
        {"/task", json::parse(R"({"for": []})")},
        {"/task", json::parse(R"({"touching": ["nobody", "nothing"]})")},
        {"/goals", json::parse(R"({"for": []})")},
        {"/goals", json::parse(R"({"touching": ["nobody", "nothing"]})")},
        {"/texts/de/title", json(7)},
        {"/texts/de/goals", json::parse(R"({"no such goal": "Text"})")},
        {"/texts/de/hints", json::array({7})},
        {"/hints/0", json(7)},
        {"/teaching/0/at", json(7)},
        {"/toolbox/0/count", json(-1)},
        {"/toolbox/0/part", json("no such part")},
        {"/placing/0", json::array({1, 2})},
        {"/solutions/0/placements", json(7)},
        {"/solutions/0/frames", json(-1)},
        {"/solutions/0/placements/0/part", json("no such part")},
        {"/editor", json(7)},
        {"/world", json(7)},
    };
    std::size_t turn = 0;
    for (auto const& [path, value] : wrong) {
        json level = whole();
        level[json::json_pointer(path)] = value;
        std::string const file = at("level.json");
        write(file, level.dump(1));
        if (refusal(file).empty()) { // then no command may refuse it, see below
            EXPECT_NE(said({"run", file, "--frames", "1"}).status, 2) << path << value;
            continue;
        }
        bool const condition = path == "/task" || path == "/goals";
        expectTheSameOfAll(level, path + " " + value.dump(),
                           condition ? std::nullopt : std::optional(turn++));
    }
}

/// All places in a document.
void collect(json const& value, json::json_pointer const& at, std::vector<json::json_pointer>& all) {
    if (value.is_object()) {
        for (auto const& [key, inner] : value.items()) {
            all.push_back(at / key);
            collect(inner, at / key, all);
        }
    } else if (value.is_array()) {
        for (std::size_t i = 0; i < value.size(); ++i) {
            all.push_back(at / i);
            collect(value[i], at / i, all);
        }
    }
}

TEST_F(BadLevels, OfRandomMistakesAreTheSameToAllCommands) {
    std::mt19937 random(20261127); // NOLINT(cert-msc51-cpp): the same levels in every run
    json const level = whole();
    std::vector<json::json_pointer> places;
    collect(level, json::json_pointer(), places);
    std::vector<json> const values{json(),      json::array(), json::object(), json(-1),
                                   json(1e300), json("x"),     json(true)};
    int refused = 0;
    for (int i = 0; i < 400 && refused < 8; ++i) {
        json changed = level;
        json::json_pointer const place = places[random() % places.size()];
        changed[place] = values[random() % values.size()];
        std::string const file = at("level.json");
        write(file, changed.dump(1));
        if (refusal(file).empty()) {
            if (i % 16 == 0) { // what the one check accepts, none refuses
                Said const ran = said({"run", file, "--frames", "1"});
                EXPECT_NE(ran.status, 2) << place.to_string() << " " << changed[place] << ran.err;
            }
            continue;
        }
        ++refused;
        expectTheSameOfAll(changed, place.to_string() + " " + changed[place].dump(),
                           static_cast<std::size_t>(refused));
    }
    EXPECT_EQ(refused, 8);
}

} // namespace
} // namespace trembler::test
