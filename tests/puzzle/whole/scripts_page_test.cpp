// docs/measurements/scripts.md links every behaviour to an existing test.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace trembler {
namespace {

std::filesystem::path const source = TREMBLER_SOURCE_DIR;

std::string contentOf(std::filesystem::path const& path) {
    std::ifstream in(path);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::set<std::string> testsIn(std::filesystem::path const& folder) {
    std::set<std::string> tests;
    std::regex const declaration(R"(\bTEST(?:_[FP])?\(\s*(\w+),\s*(\w+)\s*\))");
    for (auto const& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.path().extension() == ".cpp") {
            std::istringstream lines(contentOf(entry.path()));
            std::smatch found;
            for (std::string line; std::getline(lines, line);) {
                if (line.starts_with("TEST") && std::regex_search(line, found, declaration)) {
                    tests.insert(found[1].str() + "." + found[2].str());
                }
            }
        }
    }
    return tests;
}

TEST(ScriptsPage, NamesTestsThatExist) {
    std::string const page = contentOf(source / "docs/measurements/scripts.md");
    std::set<std::string> const tests = testsIn(source / "tests");
    ASSERT_GT(tests.size(), 100U);
    std::regex const name(R"(`([A-Z]\w+\.\w+)`)");
    int named = 0;
    std::set<std::string> linked;
    for (std::sregex_iterator at(page.begin(), page.end(), name), end; at != end; ++at) {
        linked.insert((*at)[1].str());
        EXPECT_TRUE(tests.contains((*at)[1].str())) << (*at)[1].str();
        ++named;
    }
    EXPECT_GT(named, 25);
    // Conversely, the page lists every test of the experiments.
    for (std::string const& test : tests) {
        bool const experiment = test.starts_with("ExperimentOne.") || test.starts_with("ExperimentTwo.") ||
                                test.starts_with("ExperimentThree.") || test.starts_with("ExperimentFour.");
        if (experiment && test != "ExperimentOne.ConstructsOnlyTheNeededComponents") {
            EXPECT_TRUE(linked.contains(test)) << test << " is missing from docs/measurements/scripts.md";
        }
    }
}

} // namespace
} // namespace trembler
