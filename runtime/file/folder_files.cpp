#include "runtime/file/folder_files.hpp"

#include <utility>

namespace trembler {

void FirstPaths::add(std::filesystem::path path) {
    if (!first_.insert(std::move(path)).second || first_.size() <= most_) {
        return;
    }
    first_.erase(std::prev(first_.end()));
    ++leftOut_;
}

FolderFiles filesIn(std::filesystem::path const& folder, std::string_view extension, std::size_t most) {
    FolderFiles found;
    std::error_code error;
    FirstPaths first(most);
    for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end;
         at.increment(error)) {
        if (at->path().extension() == extension) {
            first.add(at->path());
        }
    }
    found.error = error;
    found.files = first.sorted();
    found.leftOut = first.leftOut();
    return found;
}

} // namespace trembler
