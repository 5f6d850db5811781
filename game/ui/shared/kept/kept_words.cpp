#include "game/ui/shared/kept/kept_words.hpp"

#include "game/ui/shared/shown_faults.hpp"
#include "game/ui/shared/texts.hpp"

#include <cerrno>
#include <cstdlib>
#include <new>

namespace trembler::ui {
namespace {

namespace fs = std::filesystem;

char const* beginningFor(Owned what) {
    switch (what) {
    case Owned::progress:
        return text("kept.not_progress");
    case Owned::build:
        return text("kept.not_build");
    case Owned::solution:
        return text("kept.not_solution");
    case Owned::picture:
        return text("kept.not_picture");
    case Owned::clip:
        return text("kept.not_clip");
    case Owned::plot:
        return text("kept.not_plot");
    case Owned::level:
        return text("kept.not_level");
    case Owned::unsavedLevel:
        return text("kept.not_unsaved_level");
    case Owned::part:
        break;
    }
    return text("kept.not_part");
}

} // namespace

std::string shownPath(fs::path const& path) {
    char const* const home = std::getenv("HOME");
    std::string shown = path.string();
    std::string const begin = home == nullptr ? "" : home;
    bool const inHome = begin.size() > 1 && shown.starts_with(begin) &&
                        (shown.size() == begin.size() || shown[begin.size()] == '/');
    return inHome ? "~" + shown.substr(begin.size()) : shown;
}

std::string reasonInWords(OutputError const& why) {
    std::string const file = shownPath(why.file());
    switch (why.error()) {
    case ENOSPC:
    case EDQUOT:
        return textWith("kept.why_full", file);
    case EACCES:
    case EPERM:
        return textWith("kept.why_denied", file);
    case EROFS:
        return textWith("kept.why_read_only", file);
    case ENOTDIR:
    case ENOENT:
    case EISDIR:
    case ELOOP:
        return textWith("kept.why_no_place", file);
    case EWOULDBLOCK:
        return textWith("kept.why_busy", file);
    case EIO:
        return textWith("kept.why_fault", file);
    case EFBIG:
        return textWith("kept.why_too_large", file);
    default:
        return translated(why.what()) + ".";
    }
}

std::string notWritten(Owned what, OutputError const& why) {
    return std::string(beginningFor(what)) + ": " + reasonInWords(why);
}

std::string notWritten(Owned what, std::exception const& why) {
    if (auto const* const system = dynamic_cast<fs::filesystem_error const*>(&why)) {
        return notWritten(what, OutputError(system->path1(), system->code().value()));
    }
    bool const memory = dynamic_cast<std::bad_alloc const*>(&why) != nullptr;
    return std::string(beginningFor(what)) + ": " +
           (memory ? std::string(text("kept.why_memory")) : shownError(why) + ".");
}

std::string inWords(DamagedFile const& damaged) {
    std::string const file = shownPath(damaged.file);
    if (damaged.stays) {
        return textWith(damaged.lastTaken ? "kept.damaged_stays_last" : "kept.damaged_stays", file,
                        reasonInWords(*damaged.stays));
    }
    if (damaged.gone) {
        return textWith("kept.gone", file);
    }
    return textWith(damaged.lastTaken ? "kept.damaged_last" : "kept.damaged", file,
                    damaged.aside.filename().string());
}

std::string notReadable(InputError const& error) {
    return textWith("kept.not_readable", shownError(error));
}

} // namespace trembler::ui
