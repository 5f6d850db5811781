// What killed programs leave behind is removed, and what a living one writes never, whatever its number.
#include "runtime/file/output_file.hpp"
#include "runtime/file/unfinished_file.hpp"
#include "tests/support/failing_calls.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace trembler::test {
namespace {

namespace fs = std::filesystem;

class UnfinishedFiles : public testing::Test {
protected:
    void SetUp() override {
        fs::remove_all(folder);
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }

    fs::path const folder = fs::path(testing::TempDir()) / ("unfinished " + std::to_string(::getpid()));
};

TEST_F(UnfinishedFiles, OfKilledProgramsAreRemovedThoughTheirNumberIsInUseAgain) {
    fs::path const left = folder / unfinishedName("3"); // the number is that of this living process
    std::ofstream(left) << "half";
    std::ofstream(folder / ".trembler-1-0.part") << "half"; // that of the first process of all
    std::ofstream(folder / ".trembler-other") << "kept";
    std::ofstream(folder / "mine.part") << "kept";
    removeUnfinished(folder);
    EXPECT_FALSE(fs::exists(left));
    EXPECT_FALSE(fs::exists(folder / ".trembler-1-0.part"));
    EXPECT_TRUE(fs::exists(folder / ".trembler-other"));
    EXPECT_TRUE(fs::exists(folder / "mine.part"));
}

TEST_F(UnfinishedFiles, OfLivingProgramsStayThoughTheirNumberIsUnknownHere) {
    UnfinishedFile const made = makeUnfinished(folder);
    ASSERT_GE(made.descriptor, 0);
    // As one from a container or another machine: no process here has the number.
    fs::path const elsewhere = folder / ".trembler-2147483647-0.part";
    fs::rename(made.path, elsewhere);
    removeUnfinished(folder);
    EXPECT_TRUE(fs::exists(elsewhere));
    EXPECT_TRUE(inProcess([&] {
        removeUnfinished(folder);
        return fs::exists(elsewhere);
    }));
    ::close(made.descriptor);
    removeUnfinished(folder);
    EXPECT_FALSE(fs::exists(elsewhere));
}

TEST_F(UnfinishedFiles, StayWhereNothingCanBeLocked) {
    std::ofstream(folder / unfinishedName("0")) << "perhaps in use";
    FailingCalls calls;
    calls.lacks.locks = true;
    FileCallsReplaced const replaced(calls);
    removeUnfinished(folder);
    EXPECT_TRUE(fs::exists(folder / unfinishedName("0")));
    UnfinishedFile const made = makeUnfinished(folder);
    EXPECT_EQ(made.path.filename(), unfinishedName("1"));
    ::close(made.descriptor);
}

/// Removes the folder's unfinished files before each call of a writer, but not between the making of a file
/// and its locking each time: then it would never get one.
class RemovingCalls final : public FailingCalls {
public:
    explicit RemovingCalls(fs::path folder) : folder_(std::move(folder)) {}

private:
    void before(std::string const& call) override {
        if (call == "flock" && ++locked_ % 2 == 0) {
            return;
        }
        FileCalls system;
        FileCallsReplaced const replaced(system);
        removeUnfinished(folder_);
    }
    fs::path folder_;
    int locked_ = 0;
};

TEST_F(UnfinishedFiles, AreNotTakenFromTheirWriterAtAnyMoment) {
    for (FailingCalls::Lacks const& lacks : fileSystems()) {
        if (lacks.locks) {
            continue;
        }
        RemovingCalls calls(folder);
        calls.lacks = lacks;
        FileCallsReplaced const replaced(calls);
        for (int i = 0; i < 2; ++i) {
            EXPECT_NO_THROW(writeFile(folder / "it", std::to_string(i)));
        }
        auto const path = writeNewFile(
            folder, [](int number) { return "new-" + std::to_string(number); }, "x");
        EXPECT_EQ(fs::file_size(path), 1U);
    }
}

} // namespace
} // namespace trembler::test
