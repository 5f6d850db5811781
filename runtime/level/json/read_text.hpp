// Files of any kind, read whole.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace trembler {

/// The text of a file. Throws InputError if it cannot be read, is a folder, a device or a pipe, or has more
/// than `most` bytes. Thread-safe.
[[nodiscard]] std::string readText(std::filesystem::path const& path, std::size_t most);

} // namespace trembler
