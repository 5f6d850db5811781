#include "runtime/file/output_file.hpp"

#include "runtime/file/descriptor_stream.hpp"
#include "runtime/file/file_calls.hpp"
#include "runtime/file/folders.hpp"
#include "runtime/file/unfinished_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <iostream>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

namespace trembler {
namespace {

namespace fs = std::filesystem;

constexpr ::mode_t usualMode = 0666; // less the umask

/// The path under which the kernel lists an open file.
std::string descriptorPath(int descriptor) {
    return fmt::format("/proc/self/fd/{}", descriptor);
}

/// Opens a file without a name; -1 if the file system does not support such files, or cannot name them later.
int openUnnamed(fs::path const& folder) {
#ifdef O_TMPFILE
    int const made = fileCalls().open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, usualMode);
    if (made >= 0 && ::access(descriptorPath(made).c_str(), F_OK) != 0) {
        fileCalls().close(made);
        return -1;
    }
    return made;
#else
    return -1;
#endif
}

constexpr unsigned mostAttempts = 10'000;

/// Whether a file system has no hard links, or not of this file.
bool cannotLink(int error) {
    return error == EPERM || error == EOPNOTSUPP || error == ENOSYS || error == EMLINK || error == EXDEV;
}

/// Whether a file without a name can get none, which is only seen when it is tried.
bool cannotName(int error) {
    return cannotLink(error) || error == ENOENT || error == EINVAL || error == ELOOP;
}

/// Whether a file system cannot rename without replacing.
bool cannotRenameNew(int error) {
    return error == EINVAL || error == ENOSYS || error == EOPNOTSUPP;
}

/// Copies all bytes to a file that is empty. Returns 0, or the errno of the failure.
int copyAll(int from, int to) {
    std::vector<char> piece(std::size_t{1} << 16U);
    for (::off_t at = 0;;) {
        ::ssize_t const read = ::pread(from, piece.data(), piece.size(), at);
        if (read == 0) {
            return 0;
        }
        if (read < 0 && errno != EINTR) {
            return errno;
        }
        for (::ssize_t done = 0; done < read;) {
            ::ssize_t const written =
                fileCalls().write(to, piece.data() + done, static_cast<std::size_t>(read - done));
            if (written > 0) {
                done += written;
            } else if (errno != EINTR) {
                return written == 0 ? EIO : errno;
            }
        }
        at += read > 0 ? read : 0;
    }
}

} // namespace

OutputError::OutputError(fs::path file, int error)
    : std::runtime_error(
          fmt::format("{}: cannot be written: {}", file.string(), std::generic_category().message(error))),
      file_(std::move(file)), error_(error) {}

class OutputFile::Stream {
public:
    Stream(int descriptor, DescriptorBuffer::Filter filter) : buffer(descriptor, filter), out(&buffer) {}
    DescriptorBuffer buffer;
    std::ostream out;
};

OutputFile::OutputFile(fs::path target, Content content) : target_(std::move(target)), content_(content) {
    if (target_.empty()) {
        throw OutputError("the name of an output file is empty; \"-\" is the terminal");
    }
    if (isStandardOutput()) {
        std::cout.flush(); // earlier output comes first
        descriptor_ = STDOUT_FILENO;
        return;
    }
    fs::path const place = fileBehind(target_);
    struct ::stat is {};
    bool const there = ::stat(place.c_str(), &is) == 0;
    if (!there && errno != ENOENT) {
        refuse(errno);
    }
    if (there && !S_ISREG(is.st_mode)) { // a pipe or a device; for a folder open() reports the error
        descriptor_ = fileCalls().open(place.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY, 0);
        if (descriptor_ < 0) {
            refuse(errno);
        }
        return;
    }
    if (there && ::access(place.c_str(), W_OK) != 0) {
        refuse(errno);
    }
    place_ = place;
    openBeside();
    if (there) {
        fileCalls().fchmod(descriptor_, is.st_mode & 07777U);
    }
}

OutputFile::OutputFile(InFolder, fs::path folder, Content content)
    : target_(std::move(folder)), place_(target_ / "new"), content_(content) {
    openBeside();
}

OutputFile::~OutputFile() {
    stream_.reset();
    if (!named_.empty()) { // while the lock still protects the name
        fileCalls().unlink(named_.c_str());
    }
    if (descriptor_ >= 0 && !isStandardOutput()) {
        fileCalls().close(descriptor_);
    }
}

void OutputFile::openBeside() {
    descriptor_ = openUnnamed(folderOf(place_));
    if (descriptor_ < 0) {
        openNamed();
    }
}

void OutputFile::openNamed() {
    UnfinishedFile made = makeUnfinished(folderOf(place_));
    if (made.descriptor < 0) {
        refuse(made.error);
    }
    descriptor_ = made.descriptor;
    named_ = std::move(made.path);
}

std::ostream& OutputFile::stream() {
    if (!stream_) {
        bool const filtered = isStandardOutput() && content_ == Content::text;
        stream_ = std::make_unique<Stream>(descriptor_, filtered ? DescriptorBuffer::Filter::visible
                                                                 : DescriptorBuffer::Filter::none);
    }
    return stream_->out;
}

void OutputFile::failed(int error) {
    error_ = error_ != 0 ? error_ : error;
}

void OutputFile::check() {
    if (stream_) {
        failed(stream_->buffer.error());
    }
    if (error_ != 0) {
        refuse(error_);
    }
}

void OutputFile::synchronise() {
    if (stream_) {
        stream_->out.flush();
    }
    check();
    // A pipe or a device may have no storage to synchronise with.
    if (!std::exchange(synchronised_, true) && !isStandardOutput() && fileCalls().fsync(descriptor_) != 0 &&
        !place_.empty()) {
        refuse(errno);
    }
}

void OutputFile::giveName() {
    static_cast<void>(lockUnfinished(descriptor_)); // nobody else can have locked it
    for (unsigned attempt = 0; named_.empty(); ++attempt) {
        fs::path name = folderOf(place_) / unfinishedName(std::to_string(attempt));
        if (fileCalls().link(descriptorPath(descriptor_).c_str(), name.c_str()) == 0) {
            named_ = std::move(name);
        } else if (cannotName(errno)) {
            copyUnderName();
        } else if (errno != EEXIST || attempt == mostAttempts) {
            refuse(errno);
        }
    }
}

/// Of a synchronised file without a name makes one that has a temporary name.
void OutputFile::copyUnderName() {
    stream_.reset(); // which writes to the former one
    int const former = descriptor_;
    struct Close {
        int descriptor;
        ~Close() { fileCalls().close(descriptor); }
    } const close{former};
    descriptor_ = -1;
    openNamed();
    struct ::stat is {};
    if (::fstat(former, &is) == 0) {
        fileCalls().fchmod(descriptor_, is.st_mode & 07777U);
    }
    if (int const error = copyAll(former, descriptor_)) {
        refuse(error);
    }
    if (fileCalls().fsync(descriptor_) != 0) {
        refuse(errno);
    }
}

void OutputFile::closeDescriptor() {
    stream_.reset();
    // The bytes of a regular file are on its storage already.
    if (fileCalls().close(std::exchange(descriptor_, -1)) != 0 && place_.empty()) {
        refuse(errno);
    }
}

void OutputFile::commit() {
    synchronise();
    if (isStandardOutput()) {
        return;
    }
    if (!place_.empty()) {
        giveName();
        putInPlace();
    }
    closeDescriptor(); // and with it the lock, which must last until the temporary name is gone
    if (!place_.empty()) {
        synchroniseFolder(folderOf(place_));
    }
}

void OutputFile::putInPlace() {
    if (fileCalls().rename(named_.c_str(), place_.c_str()) != 0) {
        refuse(errno);
    }
    named_.clear();
}

fs::path OutputFile::commitNew(std::function<std::string(int)> const& name) {
    synchronise();
    for (int number = 1;; ++number) {
        fs::path place = target_ / name(number);
        if (!putAt(place)) {
            continue;
        }
        if (!named_.empty()) {
            fileCalls().unlink(std::exchange(named_, {}).c_str());
        }
        closeDescriptor();
        synchroniseFolder(folderOf(place_));
        return place;
    }
}

/// False if another file has that name.
bool OutputFile::putAt(fs::path const& place) {
    std::string const from = named_.empty() ? descriptorPath(descriptor_) : named_.string();
    if (fileCalls().link(from.c_str(), place.c_str()) == 0) {
        return true;
    }
    if (errno == EEXIST) {
        return false;
    }
    if (named_.empty() && cannotName(errno)) {
        copyUnderName();
        return putAt(place);
    }
    if (!cannotLink(errno)) {
        refuse(errno);
    }
    if (fileCalls().renameNew(named_.c_str(), place.c_str()) == 0) {
        named_.clear();
        return true;
    }
    if (errno == EEXIST) {
        return false;
    }
    if (!cannotRenameNew(errno)) {
        refuse(errno);
    }
    return replaceReserved(place);
}

/// Where nothing else is possible: the name is reserved by an empty file, which is then replaced. False if
/// another file has that name.
bool OutputFile::replaceReserved(fs::path const& place) {
    int const reserved = fileCalls().open(place.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, usualMode);
    if (reserved < 0) {
        if (errno == EEXIST) {
            return false;
        }
        refuse(errno);
    }
    fileCalls().close(reserved); // nothing was written that could be lost
    if (fileCalls().rename(named_.c_str(), place.c_str()) != 0) {
        int const error = errno;
        fileCalls().unlink(place.c_str());
        refuse(error);
    }
    named_.clear();
    return true;
}

void OutputFile::refuse(int error) const {
    throw OutputError(isStandardOutput() ? fs::path("standard output") : target_, error);
}

fs::path fileBehind(fs::path path) {
    constexpr int mostLinks = 40; // the kernel's limit
    for (int links = 0; links < mostLinks; ++links) {
        std::error_code error;
        fs::path const next = fs::read_symlink(path, error);
        if (error) {
            return path;
        }
        path = next.is_absolute() ? next : path.parent_path() / next;
    }
    return path;
}

void writeFile(fs::path const& target, std::string_view bytes, OutputFile::Content content) {
    OutputFile file(target, content);
    file.stream() << bytes;
    file.commit();
}

fs::path writeNewFile(fs::path const& folder, std::function<std::string(int)> const& name,
                      std::string_view bytes, OutputFile::Content content) {
    makeFolder(folder);
    OutputFile file = OutputFile::newIn(folder, content);
    file.stream() << bytes;
    return file.commitNew(name);
}

void synchroniseFolder(fs::path const& folder) {
    // One that may be written but not listed cannot be opened.
    int const descriptor = fileCalls().open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC, 0);
    if (descriptor < 0) {
        if (errno == EACCES || errno == EPERM) {
            return;
        }
        throw OutputError(folder, errno);
    }
    int const error = fileCalls().fsync(descriptor) == 0 ? 0 : errno;
    fileCalls().close(descriptor);
    if (error != 0 && error != EINVAL && error != ENOTSUP && error != EBADF && error != EROFS) {
        throw OutputError(folder, error);
    }
}

} // namespace trembler
