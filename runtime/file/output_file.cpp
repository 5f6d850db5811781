#include "runtime/file/output_file.hpp"

#include "runtime/file/descriptor_stream.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <iostream>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace trembler {
namespace {

namespace fs = std::filesystem;

constexpr ::mode_t usualMode = 0666; // less the umask

fs::path folderOf(fs::path const& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// The path under which the kernel lists an open file.
std::string descriptorPath(int descriptor) {
    return fmt::format("/proc/self/fd/{}", descriptor);
}

/// Opens a file without a name; -1 if the file system does not support such files, or cannot name them later.
int openUnnamed(fs::path const& folder) {
#ifdef O_TMPFILE
    int const made = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, usualMode);
    if (made >= 0 && ::access(descriptorPath(made).c_str(), F_OK) != 0) {
        ::close(made);
        return -1;
    }
    return made;
#else
    return -1;
#endif
}

/// An unused name in the folder of `place`.
fs::path nameBeside(fs::path const& place, unsigned attempt) {
    return folderOf(place) / fmt::format(".trembler-{}-{}.part", ::getpid(), attempt);
}

constexpr unsigned mostAttempts = 10'000;

} // namespace

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
        descriptor_ = ::open(place.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
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
        ::fchmod(descriptor_, is.st_mode & 07777U);
    }
}

OutputFile::~OutputFile() {
    stream_.reset();
    if (descriptor_ >= 0 && !isStandardOutput()) {
        ::close(descriptor_);
    }
    if (!named_.empty()) {
        ::unlink(named_.c_str());
    }
}

void OutputFile::openBeside() {
    descriptor_ = openUnnamed(folderOf(place_));
    for (unsigned attempt = 0; descriptor_ < 0 && attempt < mostAttempts; ++attempt) {
        fs::path const name = nameBeside(place_, attempt);
        descriptor_ = ::open(name.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, usualMode);
        if (descriptor_ >= 0) {
            named_ = name;
        } else if (errno != EEXIST) {
            break;
        }
    }
    if (descriptor_ < 0) {
        refuse(errno);
    }
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

void OutputFile::commit() {
    if (stream_) {
        stream_->out.flush();
    }
    check();
    if (isStandardOutput()) {
        return;
    }
    // A pipe or a device may have no storage to synchronise with.
    if (::fsync(descriptor_) != 0 && !place_.empty()) {
        refuse(errno);
    }
    if (!place_.empty() && named_.empty()) {
        unsigned attempt = 0;
        fs::path name = nameBeside(place_, attempt);
        while (::linkat(AT_FDCWD, descriptorPath(descriptor_).c_str(), AT_FDCWD, name.c_str(),
                        AT_SYMLINK_FOLLOW) != 0) {
            if (errno != EEXIST || ++attempt == mostAttempts) {
                refuse(errno);
            }
            name = nameBeside(place_, attempt);
        }
        named_ = name;
    }
    stream_.reset();
    if (::close(std::exchange(descriptor_, -1)) != 0) {
        refuse(errno);
    }
    if (!place_.empty()) {
        putInPlace();
    }
}

void OutputFile::putInPlace() {
    if (::rename(named_.c_str(), place_.c_str()) != 0) {
        refuse(errno);
    }
    named_.clear();
}

void OutputFile::refuse(int error) const {
    std::string const name = isStandardOutput() ? "standard output" : target_.string();
    throw OutputError(fmt::format("{}: cannot be written: {}", name, std::generic_category().message(error)));
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

} // namespace trembler
