// Folders that cannot be made, and that no call of the file system throws in the words of the library.
#include "runtime/file/folders.hpp"
#include "runtime/file/output_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>
#include <unistd.h>

namespace trembler {
namespace {

namespace fs = std::filesystem;

TEST(Folders, AreMadeOrRefusedInOurWords) {
    fs::path const place = fs::path(testing::TempDir()) / ("folders " + std::to_string(::getpid()));
    makeFolder(place / "a" / "b");
    EXPECT_TRUE(fs::is_directory(place / "a" / "b"));
    makeFolder(place / "a" / "b"); // is there
    makeFolder(place / "c/");
    EXPECT_TRUE(fs::is_directory(place / "c"));
    makeFolder("");
    std::ofstream(place / "file") << "x";
    fs::create_symlink(place / "none" / "nowhere", place / "link");
    for (fs::path const& impossible : {place / "file", place / "file" / "below", place / "link",
                                       place / std::string(5000, 'x'), fs::path("/proc/none")}) {
        try {
            makeFolder(impossible);
            ADD_FAILURE() << impossible;
        } catch (OutputError const& error) {
            std::string const said = error.what();
            EXPECT_TRUE(said.starts_with(impossible.string() + ": the folder cannot be made: ")) << said;
            EXPECT_EQ(said.find("filesystem error"), std::string::npos) << said;
        }
    }
    fs::remove_all(place);
}

std::string textOf(fs::path const& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// The arguments of a call whose opening bracket ends before `at`, split at commas between them.
std::vector<std::string> argumentsAt(std::string const& source, std::size_t at) {
    std::vector<std::string> arguments(1);
    for (int depth = 1; at < source.size(); ++at) {
        char const c = source[at];
        depth += c == '(' || c == '[' || c == '{' ? 1 : c == ')' || c == ']' || c == '}' ? -1 : 0;
        if (depth == 0) {
            break;
        }
        if (c == ',' && depth == 1) {
            arguments.emplace_back();
        } else {
            arguments.back() += c;
        }
    }
    return arguments;
}

/// Calls of std::filesystem in a source that throw std::filesystem::filesystem_error: those without an
/// std::error_code, which is an own variable by a usual name.
std::vector<std::string> throwingCalls(std::string const& source) {
    static std::regex const call(
        R"(::(exists|is_directory|is_regular_file|is_symlink|is_empty|file_size|create_directory|)"
        R"(create_directories|create_symlink|remove|remove_all|rename|copy|copy_file|absolute|canonical|)"
        R"(weakly_canonical|relative|equivalent|last_write_time|space|status|symlink_status|read_symlink|)"
        R"(temp_directory_path|current_path|permissions|resize_file|(recursive_)?directory_iterator( \w+)?)[({])");
    static std::regex const code(R"(\s*(error|ignored|none|gone|closed|failed|unknown|missing)\s*)");
    static std::regex const known(R"(\s*(found|\))?\s*)"); // a file_status; the end of a folder
    std::vector<std::string> found;
    for (std::size_t at = source.find("::"); at != std::string::npos; at = source.find("::", at + 2)) {
        std::string const before = source.substr(at < 10 ? 0 : at - 10, std::min<std::size_t>(at, 10));
        std::smatch match;
        if ((!before.ends_with("fs") && !before.ends_with("filesystem")) ||
            !std::regex_search(source.begin() + static_cast<std::ptrdiff_t>(at), source.end(), match, call,
                               std::regex_constants::match_continuous)) {
            continue;
        }
        auto const arguments = argumentsAt(source, at + static_cast<std::size_t>(match.length()));
        if (!std::regex_match(arguments.back(), code) && !std::regex_match(arguments.back(), known)) {
            found.push_back(match.str() + arguments.back() + ")");
        }
    }
    return found;
}

TEST(Folders, AreNeverAskedForByACallThatThrows) {
    EXPECT_EQ(throwingCalls("fs::exists(path)").size(), 1U);
    EXPECT_EQ(throwingCalls("fs::create_directories(a / f(b, c));").size(), 1U);
    EXPECT_EQ(throwingCalls("for (auto& e : fs::directory_iterator(path)) {").size(), 1U);
    EXPECT_EQ(throwingCalls("std::filesystem::rename(from, to)").size(), 1U);
    EXPECT_TRUE(
        throwingCalls("fs::exists(path, error) && fs::directory_iterator at(folder, none), end;").empty());
    for (char const* const folder :
         {"runtime", "physics", "audio", "lua", "render", "puzzle", "insight", "measure", "game"}) {
        for (auto const& entry : fs::recursive_directory_iterator(fs::path(TREMBLER_SOURCE_DIR) / folder)) {
            if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp") {
                for (std::string const& call : throwingCalls(textOf(entry.path()))) {
                    ADD_FAILURE() << entry.path() << ": " << call
                                  << " throws \"filesystem error\"; pass an std::error_code";
                }
            }
        }
    }
}

} // namespace
} // namespace trembler
