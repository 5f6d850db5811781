#include "puzzle/edit/recovery/autosave.hpp"

#include "puzzle/edit/tree/tree_access.hpp"
#include "runtime/file/data_folder.hpp"
#include "runtime/file/file_calls.hpp"
#include "runtime/file/folder_files.hpp"
#include "runtime/file/folders.hpp"
#include "runtime/file/output_file.hpp"
#include "runtime/file/path_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>

namespace trembler::edit {
namespace {

namespace fs = std::filesystem;

constexpr int recoveryVersion = 1;
/// Of a recovery file: it has the text of the level and of its file, each with at most twice the bytes when
/// it is quoted.
constexpr std::size_t largestRecovery = 4 * limits::fileSize + (std::size_t{1} << 20U);

fs::path lockFileOf(fs::path const& file) {
    fs::path lock = file;
    return lock.replace_extension(".lock");
}

/// Opens and locks a file; -1 if another program holds the lock, or it cannot be opened.
int lockedFile(fs::path const& path, int flags) {
    int const descriptor = fileCalls().open(path.c_str(), flags | O_CLOEXEC, 0600);
    if (descriptor >= 0 && fileCalls().flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
        int const error = errno;
        fileCalls().close(descriptor);
        errno = error;
        return -1;
    }
    return descriptor;
}

/// Whether a living program holds the lock of a recovery file.
bool isHeld(fs::path const& file) {
    // Opening a pipe of that name must not wait for its writer.
    int const descriptor = fileCalls().open(lockFileOf(file).c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK, 0);
    if (descriptor < 0) {
        return false;
    }
    bool const held = fileCalls().flock(descriptor, LOCK_EX | LOCK_NB) != 0;
    fileCalls().close(descriptor);
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

KeptFile recoveryFile(fs::path const& file) {
    return KeptFile(file, isWholeJson, largestRecovery);
}

/// Nothing if it is none. One that is damaged is moved aside, and its last good version taken.
std::optional<Recovery> readRecovery(fs::path const& file, RecoveryTroubles* troubles) {
    std::optional<std::string> stored;
    try {
        KeptText found = recoveryFile(file).read();
        if (found.damaged && troubles != nullptr) {
            troubles->damaged.push_back(std::move(*found.damaged));
        }
        stored = std::move(found.text);
    } catch (InputError const& error) { // it cannot be read now
        if (troubles != nullptr) {
            troubles->notRead.push_back(error);
        }
    }
    Json const all = stored ? Json::parse(*stored, nullptr, false) : Json();
    if (!all.is_object() || all.value("recovery", Json()) != recoveryVersion || !all.contains("text") ||
        !all["text"].is_string()) {
        return std::nullopt;
    }
    Recovery found;
    found.file = file;
    found.level = pathFromText(textOf(all, "level"));
    found.text = all["text"].get<std::string>();
    if (all.contains("on_disk") && all["on_disk"].is_string()) {
        found.onDisk = all["on_disk"].get<std::string>();
    }
    if (isWholeJson(found.text)) {
        found.title = textOf(Json::parse(found.text, nullptr, false), "title");
    }
    found.changedSince = textInFile(found.level) != found.onDisk;
    return found;
}

/// With its lock. What cannot be removed is offered again.
void removeRecovery(fs::path const& file) {
    try {
        recoveryFile(file).remove();
        fileCalls().unlink(lockFileOf(file).c_str());
    } catch (OutputError const&) { // the lock stays with it
    }
}

/// One whose text the level's file has is removed.
std::optional<Recovery> usefulRecovery(fs::path const& file, RecoveryTroubles* troubles) {
    auto recovery = readRecovery(file, troubles);
    if (recovery && textInFile(recovery->level) == recovery->text) {
        discard(*recovery);
        return std::nullopt;
    }
    return recovery;
}

} // namespace

fs::path recoveryFolder() {
    return inDataFolder("recovery");
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
    Json all{{"recovery", recoveryVersion}, {"level", pathAsText(level.string())}, {"text", document.text()}};
    if (document.onDisk()) {
        all["on_disk"] = *document.onDisk();
    }
    recoveryFile(file_).write(all.dump(-1, ' ', false, Json::error_handler_t::replace));
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
        fileCalls().close(lock_);
    }
    lock_ = -1;
    file_.clear();
    lockFile_.clear();
    written_.reset();
    error_.reset();
}

std::vector<Recovery> findRecoveries(fs::path const& folder, RecoveryTroubles* troubles,
                                     RecoveryLimits const& most) {
    std::vector<Recovery> found;
    if (folder.empty()) {
        return found;
    }
    FolderFiles const listed = newestFilesIn(folder, ".json", most.files); // before any of them is moved
    std::size_t leftOut = listed.leftOut;
    std::size_t bytes = 0;
    for (fs::path const& file : listed.files) {
        if (isHeld(file)) {
            continue;
        }
        std::error_code unknown;
        std::uintmax_t const size = fs::file_size(file, unknown);
        bool const fits = unknown || size <= most.bytes - std::min(bytes, most.bytes);
        if (!fits && !found.empty()) { // one is found, whatever its size
            ++leftOut;
            continue;
        }
        auto recovery = usefulRecovery(file, troubles);
        if (!recovery) {
            continue;
        }
        bytes += recovery->text.size() + recovery->onDisk.value_or("").size();
        found.push_back(std::move(*recovery));
    }
    if (troubles != nullptr) {
        troubles->leftOut += leftOut;
    }
    return found;
}

std::optional<Recovery> findRecovery(fs::path const& folder, fs::path const& level,
                                     RecoveryTroubles* troubles) {
    std::error_code ignored;
    fs::path const wanted = level.empty() ? fs::path() : fs::absolute(level, ignored).lexically_normal();
    FolderFiles const listed = newestFilesIn(folder, ".json", RecoveryLimits().files);
    for (fs::path const& file : listed.files) { // one at a time, so that their sum needs no limit
        auto recovery = isHeld(file) ? std::nullopt : usefulRecovery(file, troubles);
        if (recovery && recovery->level == wanted) {
            return recovery;
        }
    }
    if (troubles != nullptr) {
        troubles->leftOut += listed.leftOut;
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
