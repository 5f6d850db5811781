// Runs the program as a process and returns its exit status, files and printed text.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace trembler::test {

struct Ran {
    int status = -1; ///< exit status; -1: ended by a signal
    std::string out;
    std::string err;
    std::size_t mostMemory = 0; ///< bytes, resident
};

struct RunAs {
    std::string outputTo{};                     ///< a file for standard output instead of `out`
    std::optional<std::uint64_t> longestFile{}; ///< RLIMIT_FSIZE, bytes
    std::vector<std::pair<std::string, std::string>> environment{};
    std::filesystem::path folder{}; ///< working directory; empty: the current one
    /// Called with the process's id while it runs, before its output is read.
    std::function<void(int)> meanwhile{};
};

/// Runs the program with these arguments and waits for its end.
[[nodiscard]] Ran runProgram(std::vector<std::string> const& arguments, RunAs const& how = {});

/// For RunAs::meanwhile. Waits until the condition holds or the process has ended, however long that takes on
/// a busy machine; returns whether the condition held.
bool waitUntil(int process, std::function<bool()> const& condition);
/// Whether the process has a file of that folder open for writing, under any name or without one.
[[nodiscard]] bool writesInto(int process, std::filesystem::path const& folder);

/// A pipe that is full as long as this lives, so that a program that writes to it waits.
class BlockingPipe {
public:
    explicit BlockingPipe(std::filesystem::path path);
    ~BlockingPipe();
    BlockingPipe(BlockingPipe const&) = delete;
    BlockingPipe& operator=(BlockingPipe const&) = delete;

    [[nodiscard]] std::string path() const { return path_.string(); }

private:
    std::filesystem::path path_;
    int descriptor_ = -1;
};

/// A level of the project.
[[nodiscard]] std::filesystem::path levelFile(std::string const& name);
[[nodiscard]] std::string contentsOf(std::filesystem::path const& file);
void write(std::filesystem::path const& file, std::string const& text);

/// A temporary folder for each test, deleted afterwards.
class InAFolder : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;
    /// The names of all files and folders in it, sorted.
    [[nodiscard]] std::vector<std::string> names() const;
    /// The path of a file in it.
    [[nodiscard]] std::string at(std::string const& name) const { return (folder / name).string(); }
    /// Copies the shortest level into it and returns the path.
    [[nodiscard]] std::string level(std::string const& name = "level.json") const;
    /// A TREMBLER_HOME in it, "home", with copies of the project's assets and of the shortest level, which is
    /// there levels/level.json. Returns its path.
    [[nodiscard]] std::filesystem::path home() const;

    std::filesystem::path folder;
};

} // namespace trembler::test
