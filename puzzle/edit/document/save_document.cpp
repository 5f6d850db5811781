// Saving of LevelDocument.
#include "puzzle/edit/document/level_document.hpp"
#include "runtime/file/folders.hpp"
#include "runtime/file/kept_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>

namespace trembler::edit {
namespace {

namespace fs = std::filesystem;

/// Thrown out of KeptFile::change(), so that nothing is written.
struct Conflict {
    std::string message;
};

} // namespace

SaveResult LevelDocument::save(Overwrite overwrite) {
    if (readOnly_) {
        return {SaveResult::Kind::failed, "the file has errors and was opened read-only"};
    }
    if (path_.empty()) {
        return {SaveResult::Kind::failed, "the level has no file yet"};
    }
    return write(path_, overwrite);
}

SaveResult LevelDocument::saveAs(fs::path const& path, Overwrite overwrite) {
    if (path.empty() || path.filename().empty()) {
        return {SaveResult::Kind::failed, "a name for the file is missing"};
    }
    return write(path == "-" ? fs::path("./-") : path, overwrite);
}

SaveResult LevelDocument::write(fs::path const& path, Overwrite overwrite) {
    std::error_code ignored;
    bool const own = path == path_ || (!path_.empty() && fs::equivalent(path, path_, ignored));
    // Looked at while other programs wait: two that save at once must not both find the file unchanged.
    auto const textFor = [&](KeptText const& there) -> std::optional<std::string> {
        bool const damaged = there.damaged && !there.damaged->gone;
        if (overwrite == Overwrite::no && (there.inPlace() || damaged)) {
            if (!own) {
                throw Conflict{fmt::format("{} exists already", path.string())};
            }
            if (damaged || there.text != onDisk_) {
                throw Conflict{fmt::format("{} has been changed by another program", path.string())};
            }
        }
        return text();
    };
    try {
        if (!fs::is_directory(folderOf(path), ignored)) {
            throw OutputError(path, ENOENT); // no folder is made for a name that may be wrong
        }
        KeptFile(path).change(textFor);
    } catch (Conflict const& conflict) {
        return {SaveResult::Kind::conflict, conflict.message};
    } catch (OutputError const& error) {
        return {SaveResult::Kind::failed, error.what(), error};
    }
    if (path_ != path) {
        path_ = path;
        json_.reset(); // it has the old name
    }
    onDisk_ = text();
    savedState_ = state();
    gestureOpen_ = false; // the next command is a step of its own, not a part of the saved one
    return {};
}

} // namespace trembler::edit
