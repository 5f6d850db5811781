#include "runtime/level/json/read_text.hpp"

#include "runtime/level/json/refuse_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <system_error>

namespace trembler {
namespace {

/// Fills the text from a file, or shortens it if the file is shorter. Returns 0, or the errno of the failure.
int readInto(std::filesystem::path const& path, std::string& text) {
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    errno = 0;
    std::unique_ptr<std::FILE, Close> const file(std::fopen(path.c_str(), "rbe"));
    if (!file) {
        return errno;
    }
    text.resize(std::fread(text.data(), 1, text.size(), file.get()));
    return std::ferror(file.get()) == 0 ? 0 : errno;
}

} // namespace

std::string readText(std::filesystem::path const& path, std::size_t most) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) {
        refuseFile(path.string(), "is a folder", "a file");
    }
    if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error)) {
        refuseFile(path.string(), "is no ordinary file", "a file");
    }
    std::uintmax_t const size = std::filesystem::file_size(path, error);
    if (error) {
        refuseFile(path.string(), fmt::format("cannot be read: {}", error.message()), "");
    }
    if (size > most) {
        refuseFile(path.string(), fmt::format("has {} bytes", size), fmt::format("at most {}", most));
    }
    std::string text(static_cast<std::size_t>(size), '\0');
    if (int const wrong = readInto(path, text); wrong != 0) {
        refuseFile(path.string(), fmt::format("cannot be read: {}", std::generic_category().message(wrong)),
                   "");
    }
    return text;
}

} // namespace trembler
