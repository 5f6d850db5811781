// The files of a folder, however many there are.
#pragma once

#include <cstddef>
#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>
#include <vector>

namespace trembler {

/// The first paths, in their order, of any number of them. Not thread-safe.
class FirstPaths {
public:
    explicit FirstPaths(std::size_t most) : most_(most) {}

    void add(std::filesystem::path path);
    /// How many of the paths that were added are not among the first.
    [[nodiscard]] std::size_t leftOut() const { return leftOut_; }
    [[nodiscard]] std::vector<std::filesystem::path> sorted() const { return {first_.begin(), first_.end()}; }

private:
    std::size_t most_;
    std::size_t leftOut_ = 0;
    std::set<std::filesystem::path> first_;
};

struct FolderFiles {
    std::vector<std::filesystem::path> files; ///< in order
    std::size_t leftOut = 0;                  ///< further files
    std::error_code error;                    ///< of reading the folder
};

/// The entries of a folder with that extension, such as ".json"; the first `most` by name, sorted. A folder
/// that cannot be read has none. Thread-safe.
[[nodiscard]] FolderFiles filesIn(std::filesystem::path const& folder, std::string_view extension,
                                  std::size_t most);

/// The same with the `most` that were changed last, the latest first; of those with the same time the first
/// by name. Thread-safe.
[[nodiscard]] FolderFiles newestFilesIn(std::filesystem::path const& folder, std::string_view extension,
                                        std::size_t most);

} // namespace trembler
