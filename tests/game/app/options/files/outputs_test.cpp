// Outputs of the commands: complete or not written at all, never over an input, and with a message on
// failure.
#include "tests/game/app/program.hpp"

#include <nlohmann/json.hpp>

#include <csignal>

namespace trembler::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Outputs : public InAFolder {
protected:
    /// The output options of `trembler run` that need no sound.
    static std::vector<std::string> options() { return {"--trace", "--record", "--json", "--export-spice"}; }
    static std::vector<std::string> run(std::string const& level, std::vector<std::string> more) {
        std::vector<std::string> all{"run", level, "--frames", "30"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
};

bool contains(std::string const& text, std::string const& part) {
    return text.find(part) != std::string::npos;
}

TEST_F(Outputs, NeverReplaceAnInput) {
    std::string const input = level();
    std::string const before = contentsOf(input);
    fs::create_symlink(input, folder / "link");
    fs::create_hard_link(input, folder / "twin");
    fs::create_symlink("link", folder / "link to the link");
    fs::create_directory(folder / "deep");
    for (std::string const& option : options()) {
        for (char const* const name :
             {"level.json", "link", "twin", "link to the link", "deep/../level.json"}) {
            Ran const ran = runProgram(run(input, {option, at(name)}));
            EXPECT_EQ(ran.status, 2) << option << " " << name;
            EXPECT_TRUE(contains(ran.err, option)) << ran.err;
            EXPECT_EQ(contentsOf(input), before) << option << " " << name;
        }
    }
    Ran const picture = runProgram({"screenshot", input, "--out", input});
    EXPECT_EQ(picture.status, 2);
    EXPECT_EQ(contentsOf(input), before);
}

TEST_F(Outputs, NeverReplaceASolutionThatIsRead) {
    std::string const input = level();
    std::string const solution = at("solution.json");
    ASSERT_EQ(runProgram(run(input, {"--record", solution})).status, 1);
    std::string const before = contentsOf(solution);
    EXPECT_EQ(runProgram(run(input, {"--solution", solution, "--record", solution})).status, 2);
    EXPECT_EQ(contentsOf(solution), before);
    EXPECT_EQ(runProgram(run(input, {"--solution", solution, "--record", at("other.json")})).status, 1);
}

TEST_F(Outputs, NeverReplaceAPartOrALevelOfTheProgram) {
    std::string const input = level();
    fs::path const data = home();
    fs::path const part = data / "assets" / "parts" / "steel_bar.json";
    ASSERT_TRUE(fs::exists(part));
    std::vector<std::vector<std::string>> const commands{
        run(input, {"--trace"}),
        run(input, {"--json"}),
        {"screenshot", input, "--out"},
        {"accuracy", "gravity", "--brief", "--json"},
        {"accuracy", "gravity", "--brief", "--markdown"},
        {"components", "--levels", "--json"},
        {"components", "--levels", "--markdown"},
    };
    for (fs::path const& file : {part, data / "levels" / "level.json"}) {
        std::string const before = contentsOf(file);
        for (std::vector<std::string> command : commands) {
            std::string const what = command.front() + " " + command.back() + " " + file.string();
            command.push_back(file.string());
            Ran const ran = runProgram(command, {.environment = {{"TREMBLER_HOME", data.string()}}});
            EXPECT_EQ(ran.status, 2) << what;
            // A file of another kind is refused by its ending.
            EXPECT_TRUE(contains(ran.err, "not overwritten") || contains(ran.err, "the file will hold"))
                << what << ": " << ran.err;
            EXPECT_EQ(contentsOf(file), before) << what;
        }
    }
}

TEST_F(Outputs, TwoNeverShareAFile) {
    std::string const input = level();
    fs::create_symlink("new.txt", folder / "link");
    for (auto const& [one, two] : {std::pair("new.txt", "new.txt"), std::pair("new.txt", "./new.txt"),
                                   std::pair("new.txt", "link"), std::pair("-", "-")}) {
        Ran const ran = runProgram(run(input, {"--trace", one, "--record", two}), {.folder = folder});
        EXPECT_EQ(ran.status, 2) << one << " " << two;
        EXPECT_TRUE(contains(ran.err, "--record") && contains(ran.err, "--trace")) << ran.err;
        EXPECT_FALSE(fs::exists(folder / "new.txt"));
    }
    EXPECT_EQ(runProgram(run(input, {"--trace", "/dev/null", "--record", "/dev/null"})).status, 1);
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(Outputs, HaveNames) {
    std::string const input = level();
    for (std::string const& option : options()) {
        Ran const ran = runProgram(run(input, {option, ""}));
        EXPECT_EQ(ran.status, 2) << option;
        EXPECT_TRUE(contains(ran.err, option) && contains(ran.err, "empty")) << ran.err;
    }
    EXPECT_EQ(runProgram({"components", "--json", ""}).status, 2);
    EXPECT_EQ(runProgram({"screenshot", input, "--out", ""}).status, 2);
    EXPECT_EQ(runProgram({"play", "--pictures", ""}).status, 2);
    for (char const* const command : {"verify", "report", "solve"}) {
        Ran const ran = runProgram({command, input, "--resume", ""});
        EXPECT_EQ(ran.status, 2) << command;
        EXPECT_TRUE(contains(ran.err, "--resume") && contains(ran.err, "empty")) << ran.err;
    }
}

TEST_F(Outputs, ThatHoldEarlierWorkAreFiles) {
    std::string const input = level();
    for (char const* const command : {"verify", "report", "solve"}) {
        // A device would never end.
        Ran const ran = runProgram({command, input, "--resume", "/dev/full"});
        EXPECT_EQ(ran.status, 2) << command;
        EXPECT_TRUE(contains(ran.err, "/dev/full: is no ordinary file")) << ran.err;
    }
}

TEST_F(Outputs, OfFoldersAreRefusedBeforeTheWorkIfTheyAreFiles) {
    std::string const input = level();
    write(at("old"), "precious");
    for (std::vector<std::string> const& command :
         {std::vector<std::string>{"solve", input, "--runs", "1", "--keep", at("old")},
          {"accuracy", "gravity", "--brief", "--plot", at("old")},
          {"mod", "annotations", at("old")}}) {
        Ran const ran = runProgram(command);
        EXPECT_EQ(ran.status, 2) << command.front();
        EXPECT_TRUE(contains(ran.err, "is a file; expected a folder")) << command.front() << ": " << ran.err;
        EXPECT_EQ(contentsOf(at("old")), "precious");
    }
}

TEST_F(Outputs, ThatCannotBeWrittenAreReportedWithTheReason) {
    std::string const input = level();
    fs::create_directory(folder / "a folder");
    for (std::string const& option : options()) {
        Ran const folderItself = runProgram(run(input, {option, at("a folder")}));
        EXPECT_EQ(folderItself.status, 2);
        EXPECT_TRUE(contains(folderItself.err, "Is a directory")) << folderItself.err;
        Ran const nowhere = runProgram(run(input, {option, at("none/file")}));
        EXPECT_EQ(nowhere.status, 2);
        EXPECT_TRUE(contains(nowhere.err, "No such file or directory")) << nowhere.err;
        if (option == "--export-spice") {
            continue; // this level has no netlist to write
        }
        Ran const full = runProgram(run(input, {option, "/dev/full"}));
        EXPECT_EQ(full.status, 2);
        EXPECT_TRUE(contains(full.err, "No space left on device")) << full.err;
    }
}

TEST_F(Outputs, ThatExceedTheDiskLeaveTheOldFile) {
    std::string const input = level();
    auto const before = names();
    for (std::string const& option : options()) {
        if (option == "--export-spice") {
            continue; // this level has no netlist to write
        }
        write(at("old"), "precious");
        Ran const ran = runProgram({"run", input, "--frames", "300", option, at("old")}, {.longestFile = 16});
        EXPECT_EQ(ran.status, 2) << option << ran.out;
        EXPECT_TRUE(contains(ran.err, option) && contains(ran.err, "File too large")) << ran.err;
        EXPECT_EQ(contentsOf(at("old")), "precious") << option;
        fs::remove(folder / "old");
        EXPECT_EQ(names(), before) << option;
    }
}

TEST_F(Outputs, ReplaceTheOldFileAndKeepItsPermissionsAndLinks) {
    std::string const input = level();
    write(at("old"), std::string(1U << 20U, 'x'));
    fs::permissions(folder / "old", fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("old", folder / "link");
    ASSERT_EQ(runProgram(run(input, {"--json", at("link")})).status, 1);
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(fs::status(folder / "old").permissions(), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(json::parse(contentsOf(at("old")))["frames"], 30);
    EXPECT_EQ(names(), (std::vector<std::string>{"level.json", "link", "old"}));
}

TEST_F(Outputs, OfAnInterruptedRunLeaveTheOldFiles) {
    std::string const input = level();
    write(at("old"), "precious");
    BlockingPipe const rows(folder / "rows.csv"); // the run waits before its end
    auto const before = names();
    for (int const signal : {SIGINT, SIGTERM, SIGKILL}) {
        Ran const ran =
            runProgram({"run", input, "--frames", "10000", "--record", at("old"), "--watch", "world.gravity",
                        "--csv", rows.path()},
                       {.meanwhile = [&](int process) {
                           EXPECT_TRUE(waitUntil(process, [&] { return writesInto(process, folder); }));
                           ::kill(process, signal);
                       }});
        EXPECT_EQ(ran.status, -1) << ran.err;
        EXPECT_EQ(contentsOf(at("old")), "precious");
        EXPECT_EQ(names(), before);
    }
}

TEST_F(Outputs, ToAFullDeviceFail) {
    std::string const input = level();
    std::vector<std::vector<std::string>> const commands{{"--help"},
                                                         {"run", "--help"},
                                                         {"schema"},
                                                         {"components"},
                                                         {"components", "--json"},
                                                         run(input, {}),
                                                         run(input, {"--json"}),
                                                         run(input, {"--trace", "-"})};
    for (auto const& command : commands) {
        Ran const ran = runProgram(command, {.outputTo = "/dev/full"});
        EXPECT_EQ(ran.status, 2) << command[0];
        EXPECT_TRUE(contains(ran.err, "No space left on device")) << command[0] << ": " << ran.err;
    }
}

TEST_F(Outputs, HaveOneConvention) {
    std::string const input = level();
    // A hyphen, or a missing name where it may be left out, is the terminal; messages then go to standard
    // error.
    for (auto const& more : std::vector<std::vector<std::string>>{{"--json"}, {"--json", "-"}}) {
        Ran const ran = runProgram(run(input, more));
        EXPECT_EQ(json::parse(ran.out)["frames"], 30);
        EXPECT_EQ(ran.err, "");
    }
    Ran const traced = runProgram(run(input, {"--trace", "-"}));
    EXPECT_EQ(json::parse(traced.out.substr(0, traced.out.find('\n')))["id"], 1);
    EXPECT_TRUE(contains(traced.err, "state hash")) << traced.err;
    Ran const recorded = runProgram(run(input, {"--record", "-"}), {.folder = folder});
    EXPECT_EQ(json::parse(recorded.out)["name"], "recorded");
    EXPECT_FALSE(fs::exists(folder / "-"));
    // With an output file, messages go to standard output.
    Ran const filed = runProgram(run(input, {"--json", at("report.json")}));
    EXPECT_TRUE(contains(filed.out, "state hash")) << filed.out;
    EXPECT_EQ(json::parse(contentsOf(at("report.json")))["frames"], 30);
    // The level may follow the option.
    Ran const last = runProgram({"run", "--json", input, "--frames", "30"});
    EXPECT_EQ(json::parse(last.out)["level"], input);
    // The same for other commands.
    std::string const text = runProgram({"components"}).out;
    EXPECT_EQ(runProgram({"components", "--json", at("components.json")}).out, text);
    EXPECT_EQ(runProgram({"components", "--json"}).out, contentsOf(at("components.json")));
    EXPECT_EQ(runProgram({"components", "--markdown", at("components.md")}).out, text);
    EXPECT_EQ(contentsOf(at("components.md")), runProgram({"components", "--markdown", "-"}).out);
    EXPECT_EQ(runProgram({"components", "--markdown", "--json"}).status, 2) << "both to the terminal";
    // The schema is JSON already.
    std::string const schema = runProgram({"schema"}).out;
    EXPECT_TRUE(json::accept(schema));
    EXPECT_EQ(runProgram({"schema", "--json"}).out, schema);
    EXPECT_EQ(runProgram({"schema", "level"}).out, schema);
    EXPECT_NE(runProgram({"schema", "part"}).out.find("A part of Trembler"), std::string::npos);
    EXPECT_EQ(runProgram({"schema", "lesson"}).status, 2);
    EXPECT_EQ(runProgram({"schema", "--json", "-"}).out, schema);
    EXPECT_EQ(runProgram({"schema", "--json", at("schema.json")}).out, "");
    EXPECT_EQ(contentsOf(at("schema.json")), schema);
}

TEST_F(Outputs, AreExplainedWhereThereAreAny) {
    std::string const explained = "FILE can be \"-\"";
    for (char const* const command :
         {"run", "verify", "components", "schema", "accuracy", "screenshot", "clip", "keys"}) {
        EXPECT_TRUE(contains(runProgram({command, "--help"}).out, explained)) << command;
    }
    EXPECT_FALSE(contains(runProgram({"play", "--help"}).out, explained));
    EXPECT_FALSE(contains(runProgram({"--help"}).out, explained));
}

TEST_F(Outputs, OfFoldersDoNotGoToTheTerminal) {
    Ran const plots = runProgram({"accuracy", "gravity", "--brief", "--plot", "-"}, {.folder = folder});
    EXPECT_EQ(plots.status, 2);
    EXPECT_TRUE(contains(plots.err, "--plot -")) << plots.err;
    Ran const pictures = runProgram({"play", "--pictures", "-"}, {.folder = folder});
    EXPECT_EQ(pictures.status, 2);
    EXPECT_TRUE(contains(pictures.err, "--pictures -") || contains(pictures.err, "made without"))
        << pictures.err;
    EXPECT_TRUE(names().empty());
}

TEST_F(Outputs, AreWrittenWithoutANetlistThatDoesNotExist) {
    std::string const input = level();
    write(at("old.cir"), "precious");
    Ran const ran = runProgram(run(input, {"--export-spice", at("old.cir"), "--json", at("report.json"),
                                           "--record", at("solution.json")}));
    EXPECT_EQ(ran.status, 2);
    EXPECT_TRUE(contains(ran.err, "--export-spice")) << ran.err;
    EXPECT_TRUE(contains(ran.out, "state hash")) << ran.out;
    EXPECT_EQ(contentsOf(at("old.cir")), "precious");
    ASSERT_TRUE(fs::exists(at("report.json")) && fs::exists(at("solution.json"))) << ran.err;
    EXPECT_EQ(json::parse(contentsOf(at("report.json")))["frames"], 30);
    EXPECT_EQ(json::parse(contentsOf(at("solution.json")))["name"], "recorded");
}

} // namespace
} // namespace trembler::test
