#include "game/app/options/files/file_rules.hpp"

#include "runtime/file/output_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace trembler {
namespace {

namespace fs = std::filesystem;

constexpr char const* terminalName = "-";
constexpr Fault fine = std::nullopt;

std::string reason(int error) {
    return std::generic_category().message(error);
}

/// What is there under a name, with links followed.
struct Found {
    explicit Found(fs::path const& name) : error(::stat(name.c_str(), &status) == 0 ? 0 : errno) {}
    [[nodiscard]] bool isFolder() const { return error == 0 && S_ISDIR(status.st_mode); }
    [[nodiscard]] bool isFile() const { return error == 0 && S_ISREG(status.st_mode); }
    /// A pipe or a device; its name need not have an ending.
    [[nodiscard]] bool isStream() const { return error == 0 && !isFolder() && !isFile(); }

    struct ::stat status {};
    int error;
};

Fault faultOfReading(std::string const& name) {
    if (Found const found(name); found.error != 0) {
        return "cannot be read: " + reason(found.error);
    }
    return ::access(name.c_str(), R_OK) == 0 ? fine : Fault("cannot be read: " + reason(errno));
}

Fault faultOfWriting(std::string const& name) {
    if (Found const found(name); found.isFolder()) {
        return "cannot be written: " + reason(EISDIR);
    } else if (found.isStream()) { // opening a pipe would wait for its reader, and end what it reads
        return ::access(name.c_str(), W_OK) == 0 ? fine : Fault("cannot be written: " + reason(errno));
    }
    try {
        OutputFile const probe{fs::path(name)}; // without commit() nothing is written
        return fine;
    } catch (OutputError const& error) {
        std::string const message = error.what(); // begins with the name, which the caller states
        return message.substr(std::min(message.size(), name.size() + 2));
    }
}

} // namespace

Rule writableFile(CLI::App& command, FileKind const& kind) {
    return [&command, kind](std::string const& name) -> Fault {
        if (name == terminalName) {
            return kind.toTerminal ? fine : Fault("cannot be written to the terminal");
        }
        if (!Found(name).isStream() && !hasEndingOf(name, kind)) {
            return fmt::format("the file will hold {}", kind.name);
        }
        CLI::Option const* const mpi = command.get_option_no_throw("--mpi");
        return mpi != nullptr && mpi->count() > 0 ? fine : faultOfWriting(name);
    };
}

Fault faultOfOutputFolder(std::string const& name) {
    if (name == terminalName) {
        return "the terminal is no folder; a folder of this name is ./-";
    }
    // The folder itself, or the nearest one above it that is there, must take new files.
    std::error_code none;
    fs::path at = fs::absolute(name, none).lexically_normal();
    for (bool itself = true;; itself = false) {
        Found const found(at);
        if (found.error == ENOENT && fs::symlink_status(at, none).type() != fs::file_type::symlink &&
            at.has_relative_path()) {
            at = at.parent_path();
            continue;
        }
        if (found.error != 0) {
            return "cannot be made: " + reason(found.error);
        }
        if (!found.isFolder()) {
            return itself ? Fault("is a file") : Fault("cannot be made: " + reason(ENOTDIR));
        }
        return ::access(at.c_str(), W_OK | X_OK) == 0 ? fine : Fault("cannot be written: " + reason(errno));
    }
}

Fault faultOfInputFile(std::string const& name) {
    return Found(name).isFolder() ? Fault("is a folder") : faultOfReading(name);
}

Fault faultOfInputPath(std::string const& name) {
    return faultOfReading(name);
}

Fault faultOfInputFolder(std::string const& name) {
    if (Found const found(name); found.error == 0 && !found.isFolder()) {
        return "is a file";
    }
    return faultOfReading(name);
}

Fault faultOfEditedLevel(std::string const& name) {
    if (name == terminalName) {
        return "the terminal holds no level";
    }
    if (Found(name).error == 0) {
        return faultOfInputFile(name);
    }
    if (!hasEndingOf(name, file_kinds::level)) {
        return "a new level is a file whose name ends in .json";
    }
    return faultOfWriting(name);
}

CLI::Option* addLevel(CLI::App& command, std::string& target, std::string const& meaning) {
    return accepts(command.add_option("LEVEL", target, meaning)->type_name(""),
                   "a level file that can be read", faultOfInputFile);
}

CLI::Option* addLevels(CLI::App& command, std::string const& name, std::vector<std::string>& target,
                       std::string const& meaning) {
    return oncePerPath(accepts(command.add_option(name, target, meaning)->type_name(""),
                               "a level file, or a folder with levels, that can be read", faultOfInputPath));
}

CLI::Option* addOutputFolder(CLI::App& command, std::string const& option, std::optional<std::string>& target,
                             std::string const& meaning) {
    return accepts(command
                       .add_option_function<std::string>(
                           option, [&target](std::string const& folder) { target = folder; }, meaning)
                       ->type_name("DIR"),
                   "a folder, which is made if it is missing", faultOfOutputFolder);
}

} // namespace trembler
