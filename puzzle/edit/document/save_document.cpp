// Saving of LevelDocument.
#include "puzzle/edit/document/level_document.hpp"
#include "runtime/file/output_file.hpp"

#include <fmt/format.h>

#include <system_error>

namespace trembler::edit {
namespace {

namespace fs = std::filesystem;

/// The text of a file; nothing if there is none. Throws InputError if there is one that cannot be read.
std::optional<std::string> presentText(fs::path const& path) {
    std::error_code error;
    if (!fs::exists(path, error) && !error) {
        return std::nullopt;
    }
    return JsonDocument::readText(path);
}

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
    try {
        std::error_code ignored;
        bool const own = path == path_ || (!path_.empty() && fs::equivalent(path, path_, ignored));
        if (overwrite == Overwrite::no) {
            auto const present = presentText(path);
            if (present && !own) {
                return {SaveResult::Kind::conflict, fmt::format("{} exists already", path.string())};
            }
            if (present && present != onDisk_) {
                return {SaveResult::Kind::conflict,
                        fmt::format("{} has been changed by another program", path.string())};
            }
        }
        writeFile(path, text());
    } catch (OutputError const& error) {
        return {SaveResult::Kind::failed, error.what()};
    } catch (InputError const& error) { // something is there that cannot be read, such as a folder
        return {SaveResult::Kind::failed, error.diagnostics().front().print()};
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
