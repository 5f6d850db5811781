// The first files of a folder by name, in whatever order they were made.
#include "runtime/file/folder_files.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <numeric>
#include <random>
#include <string>
#include <unistd.h>

namespace trembler {
namespace {

namespace fs = std::filesystem;

TEST(FolderFiles, TheFirstByNameAreListed) {
    fs::path const folder = fs::path(testing::TempDir()) / ("folder files " + std::to_string(getpid()));
    fs::remove_all(folder);
    fs::create_directories(folder);
    std::vector<int> numbers(40);
    std::iota(numbers.begin(), numbers.end(), 10);
    std::mt19937_64 random(7);
    std::shuffle(numbers.begin(), numbers.end(), random);
    for (int const number : numbers) {
        std::ofstream(folder / (std::to_string(number) + ".json")) << "x";
        std::ofstream(folder / (std::to_string(number) + ".txt")) << "x";
    }
    for (std::size_t const most : {0U, 1U, 39U, 40U, 41U}) {
        FolderFiles const found = filesIn(folder, ".json", most);
        EXPECT_FALSE(found.error);
        ASSERT_EQ(found.files.size(), std::min<std::size_t>(most, 40));
        EXPECT_EQ(found.leftOut, 40 - found.files.size());
        for (std::size_t i = 0; i < found.files.size(); ++i) {
            EXPECT_EQ(found.files[i].filename(), std::to_string(10 + i) + ".json");
        }
    }
    fs::remove_all(folder);
    FolderFiles const none = filesIn(folder, ".json", 10);
    EXPECT_TRUE(none.error);
    EXPECT_TRUE(none.files.empty());
}

TEST(FolderFiles, TheNewestAreListed) {
    fs::path const folder = fs::path(testing::TempDir()) / ("newest files " + std::to_string(getpid()));
    fs::remove_all(folder);
    fs::create_directories(folder);
    auto const now = fs::file_time_type::clock::now();
    for (int i = 0; i < 5; ++i) { // the last by name is the newest
        fs::path const file = folder / (std::to_string(i) + ".json");
        std::ofstream(file) << "x";
        fs::last_write_time(file, now - std::chrono::hours(10 - i));
    }
    fs::last_write_time(folder / "1.json", fs::last_write_time(folder / "2.json"));
    std::vector<std::string> const expected{"4.json", "3.json", "1.json", "2.json", "0.json"};
    for (std::size_t const most : {0U, 1U, 3U, 5U, 6U}) {
        FolderFiles const found = newestFilesIn(folder, ".json", most);
        EXPECT_FALSE(found.error);
        ASSERT_EQ(found.files.size(), std::min<std::size_t>(most, 5));
        EXPECT_EQ(found.leftOut, 5 - found.files.size());
        for (std::size_t i = 0; i < found.files.size(); ++i) {
            EXPECT_EQ(found.files[i].filename(), expected[i]) << most;
        }
    }
    fs::remove_all(folder);
    EXPECT_TRUE(newestFilesIn(folder, ".json", 10).error);
}

} // namespace
} // namespace trembler
