#include "runtime/file/kept_file.hpp"

#include "runtime/file/file_calls.hpp"
#include "runtime/file/folder_lock.hpp"
#include "runtime/file/folders.hpp"
#include "runtime/file/unfinished_file.hpp"
#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/json/read_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cerrno>
#include <system_error>
#include <utility>

namespace trembler {
namespace {

namespace fs = std::filesystem;

/// What there is at a path; fs::file_type::unknown if that cannot be found out.
fs::file_type kindOf(fs::path const& path) {
    std::error_code unknown;
    return fs::status(path, unknown).type();
}

/// Whether opening or writing something of that kind may wait for another program, or never end.
bool isDeviceOrPipe(fs::file_type kind) {
    return kind == fs::file_type::fifo || kind == fs::file_type::character || kind == fs::file_type::block ||
           kind == fs::file_type::socket;
}

/// Accepts what JsonDocument accepts of nesting and values: what is deeper cannot be copied or written
/// without deep recursion, and many values take many times the memory of their text.
class ShallowJson final : public nlohmann::json::json_sax_t {
public:
    bool null() override { return count(); }
    bool boolean(bool) override { return count(); }
    bool number_integer(number_integer_t) override { return count(); }
    bool number_unsigned(number_unsigned_t) override { return count(); }
    bool number_float(number_float_t, string_t const&) override { return count(); }
    bool string(string_t&) override { return count(); }
    bool binary(binary_t&) override { return count(); }
    bool start_object(std::size_t) override { return ++depth_ <= limits::depth && count(); }
    bool key(string_t&) override { return true; }
    bool end_object() override { return --depth_, true; }
    bool start_array(std::size_t) override { return ++depth_ <= limits::depth && count(); }
    bool end_array() override { return --depth_, true; }
    bool parse_error(std::size_t, std::string const&, nlohmann::json::exception const&) override {
        return false;
    }

private:
    bool count() { return ++values_ <= limits::values; }

    std::size_t depth_ = 0;
    std::size_t values_ = 0;
};

} // namespace

bool isWholeJson(std::string_view text) {
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF"; // some editors write one
    if (text.starts_with(byteOrderMark)) {
        text.remove_prefix(byteOrderMark.size());
    }
    std::size_t const begin = text.find_first_not_of(" \t\r\n");
    ShallowJson check;
    return begin != std::string_view::npos && text[begin] == '{' && nlohmann::json::sax_parse(text, &check);
}

KeptFile::KeptFile(fs::path const& file, IsWhole whole, std::size_t most)
    : file_(fileBehind(file)), whole_(std::move(whole)), most_(most) {}

fs::path KeptFile::lastGood() const {
    fs::path last = file_;
    return last += "~";
}

/// Nothing if there is no file. Throws InputError.
std::optional<std::string> KeptFile::presentText() const {
    if (kindOf(file_) == fs::file_type::not_found) {
        return std::nullopt;
    }
    return readText(file_, most_);
}

/// Nothing if there is none, or if it is not whole itself.
std::optional<std::string> KeptFile::lastText() const {
    try {
        if (kindOf(lastGood()) == fs::file_type::regular) {
            if (std::string text = readText(lastGood(), most_); whole_(text)) {
                return text;
            }
        }
    } catch (InputError const&) { // then there is none
    }
    return std::nullopt;
}

KeptText KeptFile::look() const {
    auto present = presentText();
    if (present && whole_(*present)) {
        return {std::move(present)};
    }
    auto last = lastText();
    if (!present && !last) {
        return {};
    }
    DamagedFile damaged{.file = file_, .gone = !present, .lastTaken = last.has_value()};
    return {std::move(last), std::move(damaged)};
}

KeptText KeptFile::read() const {
    if (KeptText found = look(); !found.damaged || found.damaged->gone) {
        return found;
    }
    try {
        FolderLock const lock(folderOf(file_));
        KeptText found = look(); // as another program may have left it meanwhile
        if (found.damaged && !found.damaged->gone) {
            found.damaged->aside = moveAside();
            try {
                if (found.text) {
                    writeFile(file_, *found.text);
                }
            } catch (OutputError const&) { // it is taken again the next time
            }
        }
        return found;
    } catch (OutputError const& error) {
        KeptText found = look();
        if (found.damaged) {
            found.damaged->stays = error;
        }
        return found;
    }
}

/// Gives the file the first name FILE.damaged-NUMBER that is free; its own name is free then.
fs::path KeptFile::moveAside() const {
    for (int number = 1;; ++number) {
        fs::path aside = file_;
        aside += fmt::format(".damaged-{}", number);
        if (fileCalls().link(file_.c_str(), aside.c_str()) != 0) {
            if (errno == EEXIST) {
                continue;
            }
            int const error = errno;
            std::error_code unknown;
            fs::file_type const kind = fs::symlink_status(aside, unknown).type();
            if (error == ENAMETOOLONG || kind == fs::file_type::none || kind == fs::file_type::unknown) {
                throw OutputError(file_, error);
            }
            // No hard links here. Nobody else takes the name: the folder is locked.
            if (kind != fs::file_type::not_found) {
                continue;
            }
            if (fileCalls().rename(file_.c_str(), aside.c_str()) != 0) {
                throw OutputError(file_, errno);
            }
        } else if (fileCalls().unlink(file_.c_str()) != 0) {
            int const error = errno;
            fileCalls().unlink(aside.c_str());
            throw OutputError(file_, error);
        }
        try {
            synchroniseFolder(folderOf(file_));
        } catch (
            OutputError const&) { // it is aside; at worst the storage brings it back, and it is moved again
        }
        return aside;
    }
}

void KeptFile::write(std::string_view text) const {
    change([&](KeptText const&) { return std::string(text); });
}

KeptText KeptFile::change(std::function<std::optional<std::string>(KeptText const&)> const& text) const {
    fs::path const folder = folderOf(file_);
    makeFolder(folder);
    FolderLock const lock(folder);
    KeptText found;
    if (fs::file_type const kind = kindOf(file_);
        kind == fs::file_type::regular || kind == fs::file_type::not_found) {
        removeUnfinished(folder);
        try {
            found = look();
        } catch (InputError const& error) { // it must not be replaced by something that was made without it
            throw OutputError(error.diagnostics().front().print());
        }
    } else if (isDeviceOrPipe(kind)) {
        throw OutputError(fmt::format("{}: is no ordinary file; expected a file", file_.string()), file_,
                          EINVAL);
    } // else a folder, for which writing reports the error
    std::optional<std::string> const wanted = text(found);
    if (!wanted || (found.inPlace() && *wanted == *found.text)) {
        return found;
    }
    if (wanted->size() > most_ || !whole_(*wanted)) { // it could never be read
        throw OutputError(file_, EFBIG);
    }
    if (found.damaged && !found.damaged->gone) {
        found.damaged->aside = moveAside();
    }
    OutputFile file(file_);
    file.stream() << *wanted;
    file.synchronise();
    if (found.inPlace()) {
        keepAsLast(*found.text);
    }
    file.commit();
    return found;
}

/// The file itself stays in its place, too: at no moment is there no file.
void KeptFile::keepAsLast(std::string const& present) const {
    fs::path const last = lastGood();
    fs::path const beside = folderOf(file_) / unfinishedName("last");
    int linked = fileCalls().link(file_.c_str(), beside.c_str());
    if (linked != 0 && errno == EEXIST) { // of a program that was killed and had the same number
        fileCalls().unlink(beside.c_str());
        linked = fileCalls().link(file_.c_str(), beside.c_str());
    }
    if (linked != 0) {
        if (errno == ENOSPC || errno == EDQUOT || errno == EROFS || errno == EIO || errno == EACCES) {
            throw OutputError(last, errno);
        }
        return writeFile(last, present); // no hard links here
    }
    if (fileCalls().rename(beside.c_str(), last.c_str()) != 0) {
        int const error = errno;
        fileCalls().unlink(beside.c_str());
        if (error == ENAMETOOLONG) { // the longest names leave no room for a last good one
            return;
        }
        throw OutputError(last, error);
    }
    // If both were the same file already, the system has left both names.
    fileCalls().unlink(beside.c_str());
}

void KeptFile::remove() const {
    fs::path const folder = folderOf(file_);
    FolderLock const lock(folder);
    if (kindOf(file_) == fs::file_type::regular) { // what is damaged or cannot be read is not ours to delete
        try {
            if (KeptText const found = look(); found.damaged && !found.damaged->gone) {
                static_cast<void>(moveAside());
            }
        } catch (InputError const& error) {
            throw OutputError(error.diagnostics().front().print());
        }
    }
    // The last good one first: without the file it would be taken for it.
    for (fs::path const& path : {lastGood(), file_}) {
        if (fileCalls().unlink(path.c_str()) != 0 && errno != ENOENT && errno != ENOTDIR) {
            throw OutputError(path, errno);
        }
    }
}

} // namespace trembler
