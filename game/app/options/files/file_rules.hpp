// The rules of options that name files and folders, checked before any work. They read the file system, and
// leave it as it is.
#pragma once

#include "game/app/options/files/file_kinds.hpp"
#include "game/app/options/rule/rule.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace trembler {

/// A file that the command will write: its ending, and whether it can be written. Of a command with --mpi
/// only the ending, as its processes may be on machines that do not have the folder.
[[nodiscard]] Rule writableFile(CLI::App& command, FileKind const& kind);
/// A folder that the command will write into, and makes if it is missing.
[[nodiscard]] Fault faultOfOutputFolder(std::string const& name);
/// A file that is there and can be read.
[[nodiscard]] Fault faultOfInputFile(std::string const& name);
/// A file or a folder that is there and can be read.
[[nodiscard]] Fault faultOfInputPath(std::string const& name);
/// A folder that is there and can be read.
[[nodiscard]] Fault faultOfInputFolder(std::string const& name);
/// A level for the editor: one that is there and can be read, or a new one, which can be written.
[[nodiscard]] Fault faultOfEditedLevel(std::string const& name);

/// Argument LEVEL: one level file.
CLI::Option* addLevel(CLI::App& command, std::string& target, std::string const& meaning);
/// Argument PATH or LEVEL: level files and folders with levels.
CLI::Option* addLevels(CLI::App& command, std::string const& name, std::vector<std::string>& target,
                       std::string const& meaning);
/// An option for a folder into which the command writes.
CLI::Option* addOutputFolder(CLI::App& command, std::string const& option, std::optional<std::string>& target,
                             std::string const& meaning);

} // namespace trembler
