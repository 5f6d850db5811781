// Sentences for the player about files that are damaged or cannot be written, in the language in use.
#pragma once

#include "runtime/file/kept_file.hpp"
#include "runtime/level/json/diagnostic.hpp"

#include <cstdint>
#include <exception>
#include <filesystem>
#include <string>

namespace trembler::ui {

/// What the player owns.
enum class Owned : std::uint8_t { progress, build, solution, picture, clip, plot, level, unsavedLevel, part };

/// A path as people write it: "~" for the home.
[[nodiscard]] std::string shownPath(std::filesystem::path const& path);
/// "The solution cannot be saved: the disk is full (~/...). Make room on it."
[[nodiscard]] std::string notWritten(Owned what, OutputError const& why);
/// The same with the message of any other error.
[[nodiscard]] std::string notWritten(Owned what, std::exception const& why);
/// The reason alone, with what to do: "the disk is full (~/...). Make room on it."
[[nodiscard]] std::string reasonInWords(OutputError const& why);
/// A file that was damaged: where it is now, and what is used instead.
[[nodiscard]] std::string inWords(DamagedFile const& damaged);
/// A file that is there and cannot be read.
[[nodiscard]] std::string notReadable(InputError const& error);

} // namespace trembler::ui
