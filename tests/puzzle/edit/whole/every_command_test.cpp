// The random commands of the tests of undo are all commands that there are.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

namespace trembler::edit {
namespace {

std::string textOf(std::filesystem::path const& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST(EveryCommand, IsAmongTheRandomOnes) {
    std::filesystem::path const root(TREMBLER_SOURCE_DIR);
    std::string const made = textOf(root / "tests/puzzle/edit/any_command.cpp") +
                             textOf(root / "tests/puzzle/edit/any_further_command.cpp");
    static std::regex const declared(R"(\bCommand (\w+)\()");
    std::size_t count = 0;
    for (auto const& entry : std::filesystem::directory_iterator(root / "puzzle/edit/commands")) {
        if (entry.path().extension() != ".hpp") {
            continue;
        }
        std::string const header = textOf(entry.path());
        for (std::sregex_iterator it(header.begin(), header.end(), declared), end; it != end; ++it) {
            ++count;
            EXPECT_NE(made.find((*it)[1].str() + "("), std::string::npos)
                << (*it)[1] << " of " << entry.path().filename() << " is undone and redone by no test";
        }
    }
    EXPECT_GT(count, 70U);
}

} // namespace
} // namespace trembler::edit
