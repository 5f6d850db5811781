#include "puzzle/edit/recovery/autosave.hpp"

#include "puzzle/edit/tree/tree_access.hpp"
#include "runtime/file/file_calls.hpp"
#include "runtime/file/folder_files.hpp"
#include "runtime/file/folders.hpp"
#include "runtime/file/output_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>

namespace trembler::edit {
namespace {

namespace fs = std::filesystem;

constexpr int recoveryVersion = 1;
constexpr std::size_t mostRecoveries = 1000;                        // files that are looked at
constexpr std::size_t mostRecoveredBytes = std::size_t{256} << 20U; // of all texts together

fs::path lockFileOf(fs::path const& file) {
    fs::path lock = file;
    return lock.replace_extension(".lock");
}

/// Opens and locks a file; -1 if another program holds the lock, or it cannot be opened.
int lockedFile(fs::path const& path, int flags) {
    int const descriptor = fileCalls().open(path.c_str(), flags | O_CLOEXEC, 0600);
    if (descriptor >= 0 && ::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
        ::close(descriptor);
        return -1;
    }
    return descriptor;
}

/// Whether a living program holds the lock of a recovery file.
bool isHeld(fs::path const& file) {
    int const descriptor = ::open(lockFileOf(file).c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) {
        return false;
    }
    bool const held = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0;
    ::close(descriptor);
    return held;
}

std::optional<std::string> textInFile(fs::path const& path) {
    std::error_code error;
    if (path.empty() || !fs::exists(path, error)) {
        return std::nullopt;
    }
    try {
        return JsonDocument::readText(path);
    } catch (InputError const&) {
        return std::nullopt;
    }
}

/// Nothing if it is none. One that is damaged is moved aside, and its last good version taken.
std::optional<Recovery> readRecovery(fs::path const& file, std::vector<DamagedFile>* damaged) {
    std::optional<std::string> stored;
    try {
        KeptText found = KeptFile(file).read();
        if (found.damaged && damaged != nullptr) {
            damaged->push_back(std::move(*found.damaged));
        }
        stored = std::move(found.text);
    } catch (InputError const&) { // it cannot be read now
    }
    Json const all = stored ? Json::parse(*stored, nullptr, false) : Json();
    if (!all.is_object() || all.value("recovery", Json()) != recoveryVersion || !all.contains("text") ||
        !all["text"].is_string()) {
        return std::nullopt;
    }
    Recovery found;
    found.file = file;
    found.level = textOf(all, "level");
    found.text = all["text"].get<std::string>();
    if (all.contains("on_disk") && all["on_disk"].is_string()) {
        found.onDisk = all["on_disk"].get<std::string>();
    }
    found.title = textOf(Json::parse(found.text, nullptr, false), "title");
    found.changedSince = textInFile(found.level) != found.onDisk;
    return found;
}

/// With its lock. What cannot be removed is offered again.
void removeRecovery(fs::path const& file) {
    try {
        KeptFile(file).remove();
        fileCalls().unlink(lockFileOf(file).c_str());
    } catch (OutputError const&) { // the lock stays with it
    }
}

} // namespace

fs::path recoveryFolder() {
    if (char const* const data = std::getenv("XDG_DATA_HOME"); data != nullptr && *data != '\0') {
        return fs::path(data) / "trembler" / "recovery";
    }
    if (char const* const home = std::getenv("HOME"); home != nullptr && *home != '\0') {
        return fs::path(home) / ".local" / "share" / "trembler" / "recovery";
    }
    return {};
}

Autosave::Autosave(fs::path folder) : folder_(std::move(folder)) {}

Autosave::~Autosave() {
    close();
}

void Autosave::tick(LevelDocument const& document, double seconds) {
    since_ += seconds;
    if (since_ < interval) {
        return;
    }
    flush(document);
}

void Autosave::flush(LevelDocument const& document) {
    if (folder_.empty()) {
        return;
    }
    since_ = 0;
    if (!document.modified()) {
        close();
        return;
    }
    if (!file_.empty() && written_ == document.revision()) {
        return;
    }
    try {
        write(document);
        written_ = document.revision();
        error_.reset();
    } catch (OutputError const& error) {
        error_ = error;
    } catch (std::exception const& error) {
        error_ = OutputError(error.what());
    }
}

void Autosave::write(LevelDocument const& document) {
    if (file_.empty()) {
        takeLock();
    }
    std::error_code ignored;
    fs::path const level =
        document.path().empty() ? fs::path() : fs::absolute(document.path(), ignored).lexically_normal();
    Json all{{"recovery", recoveryVersion}, {"level", level.string()}, {"text", document.text()}};
    if (document.onDisk()) {
        all["on_disk"] = *document.onDisk();
    }
    KeptFile(file_).write(all.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void Autosave::takeLock() {
    std::error_code error;
    makeFolder(folder_);
    // The number makes the names of several documents, and of programs before this one, differ.
    for (int number = 1; number < 10000; ++number) {
        fs::path const file = folder_ / fmt::format("{}-{}.json", ::getpid(), number);
        fs::path const lock = lockFileOf(file);
        if (fs::exists(file, error)) {
            continue;
        }
        lock_ = lockedFile(lock, O_RDWR | O_CREAT | O_EXCL);
        if (lock_ >= 0) {
            file_ = file;
            lockFile_ = lock;
            return;
        }
        if (errno != EEXIST && errno != EWOULDBLOCK) {
            throw OutputError(lock, errno);
        }
    }
    throw OutputError(fmt::format("{}: has too many recovery files", folder_.string()));
}

void Autosave::close() {
    if (!file_.empty()) {
        removeRecovery(file_);
    }
    abandon();
}

void Autosave::abandon() {
    if (lock_ >= 0) {
        ::close(lock_);
    }
    lock_ = -1;
    file_.clear();
    lockFile_.clear();
    written_.reset();
    error_.reset();
}

std::vector<Recovery> findRecoveries(fs::path const& folder, std::vector<DamagedFile>* damaged) {
    std::vector<std::pair<fs::file_time_type, Recovery>> found;
    if (folder.empty()) {
        return {};
    }
    std::size_t bytes = 0;
    for (fs::path const& file :
         filesIn(folder, ".json", mostRecoveries).files) { // before any of them is moved
        if (isHeld(file)) {
            continue;
        }
        auto recovery = readRecovery(file, damaged);
        if (!recovery) {
            continue;
        }
        if (textInFile(recovery->level) == recovery->text) {
            discard(*recovery);
            continue;
        }
        bytes += recovery->text.size() + recovery->onDisk.value_or("").size();
        if (bytes > mostRecoveredBytes) {
            break; // it stays in its file, and is found when others are gone
        }
        std::error_code ignored;
        found.emplace_back(fs::last_write_time(file, ignored), std::move(*recovery));
    }
    std::sort(found.begin(), found.end(), [](auto const& a, auto const& b) {
        return a.first != b.first ? a.first > b.first : a.second.file < b.second.file;
    });
    std::vector<Recovery> recoveries;
    for (auto& [time, recovery] : found) {
        recoveries.push_back(std::move(recovery));
    }
    return recoveries;
}

std::optional<Recovery> findRecovery(fs::path const& folder, fs::path const& level,
                                     std::vector<DamagedFile>* damaged) {
    std::error_code ignored;
    fs::path const wanted = level.empty() ? fs::path() : fs::absolute(level, ignored).lexically_normal();
    for (Recovery& recovery : findRecoveries(folder, damaged)) {
        if (recovery.level == wanted) {
            return std::move(recovery);
        }
    }
    return std::nullopt;
}

LevelDocument recover(GameData const& data, Recovery const& recovery) {
    return LevelDocument::fromText(data, recovery.text, recovery.level, recovery.onDisk);
}

void discard(Recovery const& recovery) {
    removeRecovery(recovery.file);
}

} // namespace trembler::edit
