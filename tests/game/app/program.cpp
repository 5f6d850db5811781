#include "tests/game/app/program.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <poll.h>
#include <sstream>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace trembler::test {
namespace {

namespace fs = std::filesystem;

struct Pipe {
    Pipe() {
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
            throw std::runtime_error("no pipe");
        }
    }
    ~Pipe() {
        ::close(ends[0]);
        closeWriting();
    }
    Pipe(Pipe const&) = delete;
    Pipe& operator=(Pipe const&) = delete;
    void closeWriting() {
        if (ends[1] >= 0) {
            ::close(ends[1]);
            ends[1] = -1;
        }
    }
    std::array<int, 2> ends{};
};

/// In the child: never returns.
[[noreturn]] void become(std::vector<std::string> const& arguments, RunAs const& how, int out, int err) {
    int const nothing = ::open("/dev/null", O_RDONLY);
    ::dup2(nothing, STDIN_FILENO);
    if (!how.outputTo.empty()) {
        out = ::open(how.outputTo.c_str(), O_WRONLY | O_CREAT, 0666);
    }
    ::dup2(out, STDOUT_FILENO);
    ::dup2(err, STDERR_FILENO);
    if (how.longestFile) {
        ::rlimit const limit{*how.longestFile, *how.longestFile};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    for (auto const& [name, value] : how.environment) {
        ::setenv(name.c_str(), value.c_str(), 1);
    }
    if (!how.folder.empty() && ::chdir(how.folder.c_str()) != 0) {
        ::_exit(126);
    }
    std::string const program = TREMBLER_BINARY_DIR "/trembler";
    std::vector<char*> argv{const_cast<char*>(program.c_str())}; // NOLINT: the type that exec requires
    for (std::string const& argument : arguments) {
        argv.push_back(const_cast<char*>(argument.c_str())); // NOLINT
    }
    argv.push_back(nullptr);
    ::execv(program.c_str(), argv.data());
    ::_exit(127);
}

/// Reads both pipes to their ends at the same time, so that neither fills up.
void readBoth(int outEnd, int errEnd, Ran& ran) {
    std::array<::pollfd, 2> ends{{{outEnd, POLLIN, 0}, {errEnd, POLLIN, 0}}};
    while (ends[0].fd >= 0 || ends[1].fd >= 0) {
        if (::poll(ends.data(), ends.size(), -1) < 0 && errno != EINTR) {
            return;
        }
        for (std::size_t i = 0; i < ends.size(); ++i) {
            if ((ends[i].revents & (POLLIN | POLLHUP)) == 0) {
                continue;
            }
            std::array<char, 4096> buffer{};
            ssize_t const got = ::read(ends[i].fd, buffer.data(), buffer.size());
            if (got > 0) {
                (i == 0 ? ran.out : ran.err).append(buffer.data(), static_cast<std::size_t>(got));
            } else {
                ends[i].fd = -1;
            }
        }
    }
}

} // namespace

Ran runProgram(std::vector<std::string> const& arguments, RunAs const& how) {
    Ran ran;
    Pipe out;
    Pipe err;
    pid_t const child = ::fork();
    if (child == 0) {
        become(arguments, how, out.ends[1], err.ends[1]);
    }
    out.closeWriting();
    err.closeWriting();
    if (how.meanwhile) {
        how.meanwhile(child);
    }
    readBoth(out.ends[0], err.ends[0], ran);
    int status = 0;
    ::rusage used{};
    ::wait4(child, &status, 0, &used);
    ran.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    ran.mostMemory = static_cast<std::size_t>(used.ru_maxrss) * 1024;
    return ran;
}

bool waitUntil(int process, std::function<bool()> const& condition) {
    while (!condition()) {
        ::siginfo_t ended{};
        if (::waitid(P_PID, static_cast<id_t>(process), &ended, WEXITED | WNOHANG | WNOWAIT) != 0 ||
            ended.si_pid != 0) {
            return false;
        }
        ::usleep(1000);
    }
    return true;
}

bool writesInto(int process, fs::path const& folder) {
    fs::path const files = "/proc/" + std::to_string(process) + "/fd";
    std::error_code gone;
    for (fs::directory_iterator at(files, gone), end; !gone && at != end; at.increment(gone)) {
        std::error_code closed;
        std::string const target = fs::read_symlink(at->path(), closed).string();
        struct ::stat file {};
        if (!closed && target.starts_with(folder.string()) && ::stat(at->path().c_str(), &file) == 0 &&
            S_ISREG(file.st_mode)) {
            std::string const flags =
                contentsOf("/proc/" + std::to_string(process) + "/fdinfo/" + at->path().filename().string());
            std::size_t const octal = flags.find("flags:");
            if (octal != std::string::npos &&
                (std::strtoul(flags.c_str() + octal + 6, nullptr, 8) & O_ACCMODE) != O_RDONLY) {
                return true;
            }
        }
    }
    return false;
}

BlockingPipe::BlockingPipe(fs::path path) : path_(std::move(path)) {
    EXPECT_EQ(::mkfifo(path_.c_str(), 0600), 0);
    // Open for reading, too, so that a writer does not fail.
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    EXPECT_GE(descriptor_, 0);
    char const byte = 'x';
    while (::write(descriptor_, &byte, 1) == 1) {
    }
}

BlockingPipe::~BlockingPipe() {
    ::close(descriptor_);
}

fs::path levelFile(std::string const& name) {
    return fs::path(TREMBLER_SOURCE_DIR) / "levels" / name;
}

std::string contentsOf(fs::path const& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

void write(fs::path const& file, std::string const& text) {
    std::ofstream out(file, std::ios::binary);
    out << text;
    ASSERT_TRUE(out.flush()) << file;
}

void InAFolder::SetUp() {
    auto const* const test = testing::UnitTest::GetInstance()->current_test_info();
    folder = fs::path(testing::TempDir()) / (std::string("trembler ") + test->test_suite_name() + " " +
                                             test->name() + " " + std::to_string(::getpid()));
    fs::create_directories(folder);
}

void InAFolder::TearDown() {
    fs::remove_all(folder);
}

std::vector<std::string> InAFolder::names() const {
    std::vector<std::string> found;
    for (fs::directory_entry const& entry : fs::directory_iterator(folder)) {
        found.push_back(entry.path().filename().string());
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::string InAFolder::level(std::string const& name) const {
    fs::copy_file(levelFile("experiments/1-switched-electromagnet.json"), folder / name);
    return at(name);
}

fs::path InAFolder::home() const {
    fs::path const made = folder / "home";
    fs::create_directories(made / "levels");
    fs::copy(fs::path(TREMBLER_SOURCE_DIR) / "assets", made / "assets", fs::copy_options::recursive);
    fs::copy_file(levelFile("experiments/1-switched-electromagnet.json"), made / "levels" / "level.json");
    return made;
}

} // namespace trembler::test
