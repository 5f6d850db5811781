#include "runtime/file/output_file.hpp"
#include "tests/support/failing_calls.hpp"

#include <gtest/gtest.h>

#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>
#include <sys/stat.h>
#include <unistd.h>

namespace trembler {
namespace {

namespace fs = std::filesystem;

class OutputFiles : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::path(testing::TempDir()) / ("output files " + std::to_string(::getpid()));
        fs::remove_all(folder);
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }

    static std::string contentsOf(fs::path const& file) {
        std::ostringstream text;
        text << std::ifstream(file).rdbuf();
        return text.str();
    }
    [[nodiscard]] std::size_t files() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
    }
    static std::string refusalOf(std::function<void()> const& work) {
        try {
            work();
        } catch (OutputError const& error) {
            return error.what();
        }
        return "";
    }

    fs::path folder;
};

TEST_F(OutputFiles, AppearOnlyWhenComplete) {
    fs::path const target = folder / "new";
    {
        OutputFile file(target);
        file.stream() << std::string(1U << 20U, 'x') << std::flush;
        EXPECT_FALSE(fs::exists(target));
        file.commit();
        EXPECT_EQ(fs::file_size(target), 1U << 20U);
    }
    EXPECT_EQ(files(), 1U);
    {
        OutputFile file(target);
        file.stream() << "not finished" << std::flush;
        EXPECT_EQ(fs::file_size(target), 1U << 20U);
    }
    EXPECT_EQ(fs::file_size(target), 1U << 20U) << "without commit() the target is unchanged";
    EXPECT_EQ(files(), 1U);
    writeFile(target, "short");
    EXPECT_EQ(contentsOf(target), "short");
}

TEST_F(OutputFiles, FollowLinksAndKeepPermissions) {
    fs::path const target = folder / "target";
    fs::create_symlink("target", folder / "link");
    fs::create_symlink(folder / "link", folder / "link to the link");
    writeFile(folder / "link to the link", "first");
    EXPECT_EQ(contentsOf(target), "first");
    EXPECT_EQ(::chmod(target.c_str(), 0640), 0);
    writeFile(folder / "link", "second");
    EXPECT_EQ(contentsOf(target), "second");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    struct ::stat is {};
    EXPECT_EQ(::stat(target.c_str(), &is), 0);
    EXPECT_EQ(is.st_mode & 07777U, 0640U);
    fs::create_symlink("round", folder / "round");
    EXPECT_NE(refusalOf([&] { writeFile(folder / "round", ""); }).find("Too many levels"), std::string::npos);
}

TEST_F(OutputFiles, HaveThePermissionsOfAnyNewFile) {
    std::ofstream(folder / "usual") << "";
    writeFile(folder / "new", "");
    EXPECT_EQ(fs::status(folder / "new").permissions(), fs::status(folder / "usual").permissions());
}

TEST_F(OutputFiles, OfOtherKindsAreWrittenDirectly) {
    fs::path const pipe = folder / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    int const reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_GE(reader, 0);
    writeFile(pipe, "through");
    char got[16] = {};
    EXPECT_EQ(::read(reader, got, sizeof got), 7);
    EXPECT_STREQ(got, "through");
    ::close(reader);
    EXPECT_TRUE(fs::is_fifo(pipe));
    writeFile("/dev/null", "gone");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(OutputFiles, ReportWhyTheyCannotBeWritten) {
    EXPECT_NE(refusalOf([] { OutputFile file(""); }).find("empty"), std::string::npos);
    EXPECT_EQ(refusalOf([&] { OutputFile file(folder); }),
              folder.string() + ": cannot be written: Is a directory");
    EXPECT_EQ(refusalOf([] { OutputFile file("/no/such/file"); }),
              "/no/such/file: cannot be written: No such file or directory");
    EXPECT_EQ(refusalOf([] { writeFile("/dev/full", "too much"); }),
              "/dev/full: cannot be written: No space left on device");
    OutputFile full("/dev/full");
    full.check();
    full.stream() << std::string(1U << 20U, 'x');
    EXPECT_FALSE(full.stream());
    EXPECT_NE(refusalOf([&] { full.check(); }).find("No space left"), std::string::npos);
    OutputFile file(folder / "new");
    file.failed(EIO);
    EXPECT_NE(refusalOf([&] { file.commit(); }).find("Input/output error"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder / "new"));
}

TEST_F(OutputFiles, AreIndependentInOneFolder) {
    std::vector<std::unique_ptr<OutputFile>> open;
    for (int i = 0; i < 8; ++i) {
        open.push_back(std::make_unique<OutputFile>(folder / std::to_string(i)));
        open.back()->stream() << i;
    }
    for (auto const& file : open) {
        file->commit();
    }
    for (int i = 0; i < 8; ++i) {
        EXPECT_EQ(contentsOf(folder / std::to_string(i)), std::to_string(i));
    }
    EXPECT_EQ(files(), 8U);
}

TEST_F(OutputFiles, AreTheSameOnFileSystemsOfAllKinds) {
    std::string const long_(200'001, 'x'); // longer than what is copied at once
    for (test::FailingCalls::Lacks const& lacks : test::fileSystems()) {
        SetUp();
        test::FailingCalls calls;
        calls.lacks = lacks;
        FileCallsReplaced const replaced(calls);
        writeFile(folder / "it", "former");
        EXPECT_EQ(::chmod((folder / "it").c_str(), 0640), 0);
        writeFile(folder / "it", long_);
        EXPECT_EQ(contentsOf(folder / "it"), long_);
        struct ::stat is {};
        EXPECT_EQ(::stat((folder / "it").c_str(), &is), 0);
        EXPECT_EQ(is.st_mode & 07777U, 0640U);
        auto const named = [](int number) { return "new-" + std::to_string(number); };
        EXPECT_EQ(writeNewFile(folder, named, long_), folder / "new-1");
        EXPECT_EQ(writeNewFile(folder, named, "2"), folder / "new-2");
        EXPECT_EQ(contentsOf(folder / "new-1"), long_);
        EXPECT_EQ(contentsOf(folder / "new-2"), "2");
        EXPECT_EQ(files(), 3U) << "nothing is left behind";
    }
}

TEST_F(OutputFiles, ThatAreNewAreThereWholeOrNotAtAll) {
    auto const named = [](int number) { return "new-" + std::to_string(number); };
    for (test::FailingCalls::Lacks const& lacks : test::fileSystems()) {
        for (int at = 1;; ++at) {
            SetUp();
            test::FailingCalls calls(test::FailingCalls::Then::failOnce, at, ENOSPC);
            calls.lacks = lacks;
            FileCallsReplaced const replaced(calls);
            bool written = false;
            try {
                written = !writeNewFile(folder, named, "whole").empty();
            } catch (OutputError const& error) {
                EXPECT_EQ(error.error(), ENOSPC);
            }
            for (auto const& entry : fs::directory_iterator(folder)) {
                bool const unfinished = entry.path().extension() == ".part"; // that could not be removed
                EXPECT_TRUE(unfinished || contentsOf(entry.path()) == "whole") << at << entry.path();
            }
            EXPECT_TRUE(!written || fs::exists(folder / "new-1")) << at;
            if (at > calls.calls()) {
                EXPECT_TRUE(written);
                EXPECT_EQ(files(), 1U);
                break;
            }
        }
    }
}

} // namespace
} // namespace trembler
