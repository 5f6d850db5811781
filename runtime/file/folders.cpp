#include "runtime/file/folders.hpp"

#include "runtime/file/file_calls.hpp"
#include "runtime/file/output_file.hpp"

#include <climits>
#include <fmt/format.h>

#include <cerrno>
#include <system_error>

namespace trembler {
namespace fs = std::filesystem;
namespace {

// Returns the errno of the failure, or 0.
int make(fs::path const& folder) {
    std::error_code unknown;
    if (folder.empty() || fs::is_directory(folder, unknown)) {
        return 0;
    }
    fs::path const above = folderOf(folder);
    if (!folder.has_filename()) { // the "/" at the end of a name
        return above != folder ? make(above) : ENOENT;
    }
    if (int const error = make(above)) {
        return error;
    }
    if (fileCalls().mkdir(folder.c_str(), 0777) == 0) {
        synchroniseFolder(above);
    } else if (int const error = errno; !fs::is_directory(folder, unknown)) {
        return error == EEXIST ? ENOTDIR : error; // a file has that name
    }
    return 0;
}

} // namespace

fs::path folderOf(fs::path const& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

void makeFolder(fs::path const& folder) {
    // The system refuses longer ones anyway; this keeps the recursion short.
    if (int const error = folder.native().size() < PATH_MAX ? make(folder) : ENAMETOOLONG) {
        throw OutputError(
            fmt::format("{}: the folder cannot be made: {}; name one in a folder that can be written",
                        folder.string(), std::generic_category().message(error)),
            folder, error);
    }
}

} // namespace trembler
