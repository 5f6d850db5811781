#include "runtime/file/folders.hpp"

#include "runtime/file/output_file.hpp"

#include <fmt/format.h>

#include <system_error>

namespace trembler {

void makeFolder(std::filesystem::path const& folder) {
    if (folder.empty()) {
        return;
    }
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::error_code unknown;
    if (!std::filesystem::is_directory(folder,
                                       unknown)) { // a trailing slash makes create_directories() report none
        throw OutputError(
            fmt::format("{}: the folder cannot be made: {}; name one in a folder that can be written",
                        folder.string(), error ? error.message() : "there is something else"));
    }
}

} // namespace trembler
