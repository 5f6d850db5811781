#include "game/mods/file_watch.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <unistd.h>

namespace trembler {
namespace {

namespace fs = std::filesystem;

class WatchedFiles : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::path(testing::TempDir()) /
                 fmt::format("trembler-watch-{}-{}", ::getpid(),
                             testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }

    /// Saves a file at a stated time: clocks play no part.
    fs::path save(std::string const& name, std::string const& text, int time) const {
        fs::path const path = folder / name;
        std::ofstream(path, std::ios::binary) << text;
        fs::last_write_time(path, fs::file_time_type(std::chrono::seconds(time)));
        return path;
    }
    static std::string told(FileWatch& watch) {
        std::string all;
        for (FileWatch::Change const& change : watch.look()) {
            all += fmt::format("{}={};", change.file, change.text.value_or("(gone)"));
        }
        return all;
    }
    fs::path folder;
};

TEST_F(WatchedFiles, AreReportedOnceTheyStayAsTheyAre) {
    FileWatch watch({save("a", "one", 1), save("b", "two", 1)}, 100);
    EXPECT_EQ(told(watch), "");
    save("b", "half", 2);
    EXPECT_EQ(told(watch), "") << "it may still be written";
    save("b", "half and half", 3);
    EXPECT_EQ(told(watch), "");
    EXPECT_EQ(told(watch), "1=half and half;");
    EXPECT_EQ(told(watch), "") << "once";
}

TEST_F(WatchedFiles, OfOneLengthDifferByTheirTime) {
    FileWatch watch({save("a", "one", 1)}, 100);
    save("a", "two", 2);
    (void)told(watch);
    EXPECT_EQ(told(watch), "0=two;");
}

TEST_F(WatchedFiles, ThatAreSavedAsTheyWereHaveNotChanged) {
    FileWatch watch({save("a", "one", 1)}, 100);
    save("a", "one", 2);
    (void)told(watch);
    EXPECT_EQ(told(watch), "");
}

TEST_F(WatchedFiles, MayGoAndComeBack) {
    fs::path const path = save("a", "one", 1);
    FileWatch watch({path, folder / "later"}, 100);
    fs::remove(path);
    (void)told(watch);
    EXPECT_EQ(told(watch), "0=(gone);");
    EXPECT_EQ(told(watch), "");
    save("a", "one", 5);
    save("later", "new", 5);
    (void)told(watch);
    EXPECT_EQ(told(watch), "0=one;1=new;");
    save("other", "renamed over it", 6);
    fs::rename(folder / "other", path); // as editors do when they save
    (void)told(watch);
    EXPECT_EQ(told(watch), "0=renamed over it;");
}

TEST_F(WatchedFiles, AreReadOnlyToTheirLimit) {
    FileWatch watch({save("a", "", 1)}, 4);
    save("a", "123456789", 2);
    (void)told(watch);
    EXPECT_EQ(told(watch), "0=12345;") << "one byte more than allowed, so that it is seen to be too long";
}

} // namespace
} // namespace trembler
