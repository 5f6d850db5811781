// Files that the player owns, on a disk that is really full and on one that is really read-only. Skipped
// where the system does not let a user mount a disk of its own.
#include "runtime/file/kept_file.hpp"
#include "tests/support/failing_calls.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sched.h>
#include <sys/mount.h>

namespace trembler::test {
namespace {

namespace fs = std::filesystem;

/// Whether this process, which is a child with one thread, has now a disk of 256 KB at the folder, which no
/// other process sees and which goes with it.
bool mountOwnDisk(fs::path const& folder) {
    uid_t const user = ::getuid();
    gid_t const group = ::getgid();
    if (::unshare(CLONE_NEWNS) != 0) { // not the administrator
        if (::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) {
            return false;
        }
        std::ofstream("/proc/self/setgroups") << "deny";
        std::ofstream("/proc/self/uid_map") << "0 " << user << " 1";
        std::ofstream("/proc/self/gid_map") << "0 " << group << " 1";
    }
    return ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
           ::mount("tmpfs", folder.c_str(), "tmpfs", 0, "size=256k,mode=700") == 0;
}

/// Fills the disk to the last byte; removing "filler" makes room again.
void fillDisk(fs::path const& folder) {
    std::ofstream filler(folder / "filler", std::ios::binary);
    while (filler << std::string(512, 'x') << std::flush) {
    }
}

int reasonOf(std::function<void()> const& write) {
    try {
        write();
        return 0;
    } catch (OutputError const& error) {
        return error.error();
    }
}

/// The checks of a process with a disk of its own. Returns the first that failed; "" if all hold.
std::string lostOn(fs::path const& folder) {
    std::string const former = "{\"stars\": 1}";
    std::string const large = "{\"names\": \"" + std::string(20'000, 'n') + "\"}";
    KeptFile const file(folder / "it.json");
    file.write(former);
    fillDisk(folder);
    if (reasonOf([&] { file.write(large); }) != ENOSPC) {
        return "a full disk is not reported";
    }
    if (file.read().text != former || file.read().damaged) {
        return "a full disk takes the former text";
    }
    if (reasonOf([&] {
            static_cast<void>(writeNewFile(
                folder, [](int number) { return "new-" + std::to_string(number); }, large));
        }) != ENOSPC ||
        fs::exists(folder / "new-1")) {
        return "something of a new file is on the full disk";
    }
    fs::remove(folder / "filler");
    file.write(large);
    if (file.read().text != large) {
        return "it is not written when there is room again";
    }
    if (::mount("none", folder.c_str(), nullptr, MS_REMOUNT | MS_RDONLY, "size=256k") != 0) {
        return "the disk cannot be made read-only";
    }
    if (reasonOf([&] { file.write(former); }) != EROFS || reasonOf([&] { file.remove(); }) != EROFS) {
        return "a read-only disk is not reported";
    }
    if (file.read().text != large) {
        return "a read-only disk takes the text";
    }
    if (::mount("none", folder.c_str(), nullptr, MS_REMOUNT, "size=256k") != 0) {
        return "the disk cannot be made writable";
    }
    { std::ofstream(folder / "it.json") << "{"; }
    if (::mount("none", folder.c_str(), nullptr, MS_REMOUNT | MS_RDONLY, "size=256k") != 0) {
        return "the disk cannot be made read-only again";
    }
    KeptText const damaged = file.read();
    if (damaged.text != former || !damaged.damaged || !damaged.damaged->stays ||
        damaged.damaged->stays->error() != EROFS) {
        return "on a read-only disk the last good version of a damaged file is not taken";
    }
    return "";
}

TEST(KeptFilesOnADisk, ThatIsFullOrReadOnlyLoseNothing) {
    fs::path const folder = fs::path(testing::TempDir()) / ("own disk " + std::to_string(::getpid()));
    fs::create_directories(folder);
    constexpr int cannotMount = 77;
    int ends[2] = {};
    ASSERT_EQ(::pipe(ends), 0);
    ::pid_t const child = ::fork();
    if (child == 0) {
        if (!mountOwnDisk(folder)) {
            ::_exit(cannotMount);
        }
        std::string lost;
        try {
            lost = lostOn(folder);
        } catch (std::exception const& error) {
            lost = error.what();
        }
        ::_exit(::write(ends[1], lost.data(), lost.size()) == static_cast<::ssize_t>(lost.size()) ? 0 : 1);
    }
    ::close(ends[1]);
    std::string lost;
    char piece[256];
    for (::ssize_t got = 0; (got = ::read(ends[0], piece, sizeof piece)) > 0;) {
        lost.append(piece, static_cast<std::size_t>(got));
    }
    ::close(ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    fs::remove_all(folder);
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == cannotMount) {
        GTEST_SKIP() << "no disk of its own can be mounted here (unshare and mount of a tmpfs)";
    }
    EXPECT_EQ(WEXITSTATUS(status), 0);
    EXPECT_EQ(lost, "");
}

} // namespace
} // namespace trembler::test
