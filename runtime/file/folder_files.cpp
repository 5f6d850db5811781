#include "runtime/file/folder_files.hpp"

#include <functional>
#include <utility>

namespace trembler {

void FirstPaths::add(std::filesystem::path path) {
    if (!first_.insert(std::move(path)).second || first_.size() <= most_) {
        return;
    }
    first_.erase(std::prev(first_.end()));
    ++leftOut_;
}

namespace {

/// Calls `use` with each entry of that extension. Returns the error of reading the folder.
std::error_code forEachFile(std::filesystem::path const& folder, std::string_view extension,
                            std::function<void(std::filesystem::directory_entry const&)> const& use) {
    std::error_code error;
    for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end;
         at.increment(error)) {
        if (at->path().extension() == extension) {
            use(*at);
        }
    }
    return error;
}

} // namespace

FolderFiles filesIn(std::filesystem::path const& folder, std::string_view extension, std::size_t most) {
    FolderFiles found;
    FirstPaths first(most);
    found.error = forEachFile(folder, extension, [&](auto const& entry) { first.add(entry.path()); });
    found.files = first.sorted();
    found.leftOut = first.leftOut();
    return found;
}

FolderFiles newestFilesIn(std::filesystem::path const& folder, std::string_view extension, std::size_t most) {
    using Time = std::filesystem::file_time_type;
    struct Later {
        bool operator()(std::pair<Time, std::filesystem::path> const& a,
                        std::pair<Time, std::filesystem::path> const& b) const {
            return a.first != b.first ? a.first > b.first : a.second < b.second;
        }
    };
    FolderFiles found;
    std::set<std::pair<Time, std::filesystem::path>, Later> newest;
    found.error = forEachFile(folder, extension, [&](std::filesystem::directory_entry const& entry) {
        std::error_code unknown;
        newest.emplace(entry.last_write_time(unknown), entry.path());
        if (newest.size() > most) {
            newest.erase(std::prev(newest.end()));
            ++found.leftOut;
        }
    });
    for (auto const& [time, path] : newest) {
        found.files.push_back(path);
    }
    return found;
}

} // namespace trembler
