// Files that are none to be read: folders, pipes and devices.
#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/json/read_text.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

namespace trembler {
namespace {

std::string refusalOf(std::filesystem::path const& path) {
    try {
        (void)readText(path, 1000);
    } catch (InputError const& error) {
        return error.diagnostics().front().message + "; expected " + error.diagnostics().front().expected;
    }
    return "read";
}

TEST(ReadText, RefusesWhatIsNoFile) {
    std::filesystem::path const pipe =
        std::filesystem::path(testing::TempDir()) / ("pipe " + std::to_string(getpid()));
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(refusalOf(pipe), "is no ordinary file; expected a file");
    EXPECT_EQ(refusalOf("/dev/null"), "is no ordinary file; expected a file");
    EXPECT_EQ(refusalOf(testing::TempDir()), "is a folder; expected a file");
    EXPECT_EQ(refusalOf("/none/such").substr(0, 15), "cannot be read:");
    std::filesystem::remove(pipe);
}

} // namespace
} // namespace trembler
