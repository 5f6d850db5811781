#include "tests/game/app/options/option_table.hpp"

#include "game/app/options/rule/rule.hpp"
#include "tests/game/app/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>

namespace trembler::test {
namespace {

namespace fs = std::filesystem;

/// What options take that are neither numbers nor files to write, by name.
struct OptionWords {
    std::vector<std::string> right;
    std::vector<std::string> wrong; ///< beyond what is wrong for any option; none: see `whyNot`
    std::string whyNot{};           ///< why no wrong value is known before the work
};

std::map<std::string, OptionWords> const& wordsByOption() {
    static std::string const mods = TREMBLER_SOURCE_DIR "/mods";
    static std::map<std::string, OptionWords> const table{
        {"--detail",
         {{"dynamics=chipmunk", "electricity=single-cable"},
          {"dynamics", "=", "dynamics=", "=box2d", "dynamics=warp", "dynamic=chipmunk",
           "dynamics=chipmunk "}}},
        {"--period",
         {{"Dynamics Resolver=2", "Electricity Resolver=3"},
          {"Dynamics Resolver", "Dynamics Resolver=", "=2", "Dynamics Resolver=0", "Dynamics Resolver=-1",
           "Dynamics Resolver=2.5", "Dynamics Resolver=nan", "Dynamics Resolver=02",
           "Dynamics Resolver=3601"}}},
        {"--watch", {{"world.gravity", "ball.position"}, {"gravity", ".x", "ball.", "."}}},
        {"--size",
         {{"100x100", "64x32"},
          {"100", "x", "100x", "x100", "100x100x", "0x0", "-100x100", "nanxnan", "99999x16", "100x100 "}}},
        {"--language", {{"de", "en"}, {"fr", "DE", "en "}}},
        {"KIND", {{"part", "chapter"}, {"lesson", "levels", "PART"}}},
        {"EFFECT", {{"gravity", "dynamics"}, {"gravitation", "Gravity", "all"}}},
        {"--trust", {{"tap", "wind"}, {"tapp", "TAP", "../tap"}}},
        {"MOD", {{"tap", mods + "/tap"}, {"tapp", mods, mods + "/tap/mod.json"}}},
        {"NAME", {{"my-mod", "other"}, {"My-Mod", "my mod", "a/b", std::string(41, 'm')}}},
        {"--mod", {{mods, mods + "/tap"}, {mods + "/tap/mod.json"}}},
        {"--solution", {{"name", "other"}, {}, "a name or a file, which depends on the level"}},
        {"--goal", {{"goal 1", "goal 2"}, {}, "goals are those of the level"}},
        {"--object", {{"ball", "lamp"}, {}, "objects are those of the level"}},
    };
    return table;
}

/// What an option needs besides, or does nothing without.
std::vector<std::string> companions(std::string const& option) {
    static std::map<std::string, std::vector<std::string>> const table{
        {"--every", {"--watch", "world.gravity", "--csv", "-"}},
        {"--csv", {"--watch", "world.gravity"}},
        {"--svg", {"--watch", "world.gravity"}},
        {"--watch", {"--csv", "-"}},
        {"--at", {"--object", "ball"}},
        {"--object", {"--at", "1"}},
        {"--table", {"--markdown", "-"}},
        {"--sections", {"--markdown", "-"}},
        {"--each-run", {"--markdown", "-"}},
    };
    auto const found = table.find(option);
    return found == table.end() ? std::vector<std::string>() : found->second;
}

void addWrong(TestedOption& option, std::string const& value, std::string const& why) {
    option.wrong.push_back({option.with(value), value, why});
}

/// "N in [1 - 100]", "NUMBER in [0.1 - 600]"
void describeNumber(TestedOption& option, std::string const& type) {
    std::string const range = type.substr(type.find('[') + 1);
    std::string const least = range.substr(0, range.find(' '));
    std::string const most = range.substr(range.rfind(' ') + 1, range.rfind(']') - range.rfind(' ') - 1);
    option.right = {least, most};
    for (char const* const text : {"nan", "NaN", "inf", "-inf", "1e999", "0x1", "+1", " 1", "1 ", "1x", "x",
                                   "1,5", "007", "-", "--", "1 2"}) {
        addWrong(option, text, "no number");
    }
    addWrong(option, "9" + most, "above the range");
    addWrong(option, "-" + most, "below the range");
    addWrong(option, least + "e", "rubbish behind a number");
    if (type.starts_with("N ")) {
        addWrong(option, least + ".5", "no whole number");
        addWrong(option, "99999999999999999999", "above every range");
    }
}

void describeOutput(TestedOption& option, std::string const& type, Places const& places) {
    std::size_t const dot = type.find('.');
    std::string const ending = dot == std::string::npos ? "" : type.substr(dot, type.find(']') - dot);
    option.right = {places.at("new" + ending), places.at("other" + ending)};
    addWrong(option, places.folder.string(), "a folder");
    addWrong(option, places.belowAFile + ending, "below a file");
    addWrong(option, places.inNoFolder + ending, "in a missing folder");
    addWrong(option, places.tooLong + ending, "too long");
    addWrong(option, places.dangling, "a link to nowhere");
    if (!ending.empty()) { // the journal of --resume has no usual ending
        addWrong(option, places.at("new.gif"), "another ending");
        addWrong(option, places.at("new" + ending + ".gif"), "another ending");
    } else {
        EXPECT_EQ(option.name, "--resume") << option.words() << ": what does its file hold?";
    }
}

void describeOutputFolder(TestedOption& option, Places const& places) {
    option.right = {places.at("made"), places.at("made/in/it")};
    addWrong(option, places.level, "a file");
    addWrong(option, places.belowAFile, "below a file");
    addWrong(option, places.tooLong, "too long");
    addWrong(option, places.dangling, "a link to nowhere");
    addWrong(option, "-", "the terminal");
}

void addMissing(TestedOption& option, Places const& places) {
    addWrong(option, places.at("none"), "missing");
    addWrong(option, places.belowAFile, "below a file");
    addWrong(option, places.tooLong, "too long");
    addWrong(option, places.dangling, "a link to nowhere");
}

void describe(TestedOption& option, std::string const& type, Places const& places) {
    bool const edited = option.command.front() == "edit";
    if (option.name == "LEVEL" || option.name == "PATH") {
        option.right = {places.level, places.otherLevel};
        if (edited) { // a new level has a name under which it can be saved
            addWrong(option, places.belowAFile, "below a file");
            addWrong(option, places.tooLong, "too long");
            addWrong(option, places.at("new.txt"), "another ending");
            addWrong(option, "-", "the terminal");
        } else {
            addMissing(option, places);
        }
        if (!option.list) {
            addWrong(option, places.folder.string(), "a folder");
        }
    } else if (type.starts_with("N in") || type.starts_with("NUMBER in")) {
        describeNumber(option, type);
    } else if (type.find("FILE") != std::string::npos && type.find('|') == std::string::npos) {
        describeOutput(option, type, places);
    } else if (auto const known = wordsByOption().find(option.name); known != wordsByOption().end()) {
        option.right = known->second.right;
        for (std::string const& value : known->second.wrong) {
            addWrong(option, value, "none of its words");
        }
        EXPECT_NE(known->second.wrong.empty(), known->second.whyNot.empty()) << option.words();
        if (option.name == "--mod") {
            addMissing(option, places);
            addWrong(option, places.emptyFolder, "without a mod");
        }
    } else if (type == "DIR" || option.name == "DIR") {
        describeOutputFolder(option, places);
    } else {
        ADD_FAILURE() << option.words() << " (" << type
                      << "): state in option_table.cpp which values are wrong";
    }
}

void addOptions(CLI::App& command, std::vector<std::string> const& words, Places const& places,
                std::vector<TestedOption>& all) {
    std::vector<TestedOption> own;
    std::vector<std::pair<std::string, std::string>> required; // by option: a right value
    for (CLI::Option* const option : command.get_options()) {
        if (option == command.get_help_ptr() || words.empty()) {
            continue;
        }
        TestedOption tested{.command = words, .name = option->get_name()};
        tested.flag = option->get_items_expected_max() == 0;
        tested.list = !tested.flag && option->get_expected_max() > 1;
        tested.expected = expectedBy(*option);
        if (!tested.flag) {
            describe(tested, option->get_type_name(), places);
        }
        // Without a level of their own these commands take the name behind --json for it, see takeBack().
        static std::set<std::string> const taken{"run", "why", "solve", "report", "verify"};
        bool const needed = option->get_required() || ((tested.name == "LEVEL" || tested.name == "PATH") &&
                                                       taken.contains(words.front()));
        if (needed && !tested.right.empty()) {
            required.emplace_back(tested.name, tested.right.front());
        }
        own.push_back(std::move(tested));
    }
    for (TestedOption& tested : own) {
        tested.besides = companions(tested.name);
        for (auto const& [name, value] : required) {
            if (name != tested.name) {
                TestedOption const needed{.command = words, .name = name};
                std::vector<std::string> const stated = needed.with(value);
                // Positional arguments first, as a list would take them for its own.
                tested.besides.insert(name.starts_with("-") ? tested.besides.end() : tested.besides.begin(),
                                      stated.begin(), stated.end());
            }
        }
        all.push_back(std::move(tested));
    }
    for (CLI::App* const inner : command.get_subcommands([](CLI::App*) { return true; })) {
        std::vector<std::string> longer = words;
        longer.push_back(inner->get_name());
        addOptions(*inner, longer, places, all);
    }
}

} // namespace

std::string TestedOption::words() const {
    std::string text = "trembler";
    for (std::string const& word : command) {
        text += " " + word;
    }
    return text + " " + name;
}

std::vector<std::string> TestedOption::with(std::string const& value) const {
    return name.starts_with("-") ? std::vector{name, value} : std::vector{value};
}

std::vector<std::string> TestedOption::stated(std::vector<std::string> const& so) const {
    std::vector<std::string> all = command;
    all.insert(all.end(), besides.begin(), besides.end());
    all.insert(all.end(), so.begin(), so.end());
    return all;
}

Places::Places(fs::path const& where) : folder(where) {
    level = at("level.json");
    otherLevel = at("other.json");
    fs::copy_file(levelFile("experiments/1-switched-electromagnet.json"), level);
    fs::copy_file(level, otherLevel);
    belowAFile = level + "/below";
    inNoFolder = at("none/new");
    emptyFolder = at("empty");
    fs::create_directory(emptyFolder);
    dangling = at("link");
    fs::create_symlink(at("none/nowhere"), dangling);
    tooLong = std::string(5000, 'x');
}

std::vector<TestedOption> allOptions(Places const& places) {
    CLI::App program;
    Work work;
    addCommands(program, work);
    std::vector<TestedOption> all;
    addOptions(program, {}, places, all);
    return all;
}

} // namespace trembler::test
