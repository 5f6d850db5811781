// The targets of the fuzzers: libFuzzer calls these with inputs that it generates, and a test calls them with
// the kept inputs.
#pragma once

#include <string>
#include <string_view>

namespace trembler::lua {

/// Takes the bytes for the text of a script: a whole script if it contains 'interaction', else the body of
/// apply. Reads it and, if it is valid, runs it in a world beside another script.
void fuzzScriptText(std::string_view bytes);

/// Makes a script out of the bytes that calls functions of a resolver with arguments of all kinds, valid and
/// invalid ones, for objects that exist or no longer do, and runs it in a world.
void fuzzCallArguments(std::string_view bytes);
/// The script that fuzzCallArguments() makes.
[[nodiscard]] std::string scriptOfCalls(std::string_view bytes);

} // namespace trembler::lua

namespace trembler::edit {

/// Takes the bytes up to the first zero for the text of a level, and the rest for commands of the editor.
/// Runs them, looks for problems, and undoes and redoes everything. Throws std::logic_error if that does not
/// give the same files.
void fuzzLevelEdit(std::string_view bytes);

} // namespace trembler::edit

/// Each takes the bytes for a file, and throws std::logic_error if a requirement is violated. Errors in the
/// file must be reported in words.
namespace trembler::files {

/// A level: read, and run on one and two threads.
void fuzzLevel(std::string_view bytes);
/// A part: read, and used as an object of a level.
void fuzzPart(std::string_view bytes);
/// A solution in a file of its own, for the doorbell: played, recorded and played again.
void fuzzReplay(std::string_view bytes);
/// The player's settings, keys and progress: read, bound, written and read again.
void fuzzSettings(std::string_view bytes);
/// A mod's mod.json up to the first zero, then the text of a script of it.
void fuzzModManifest(std::string_view bytes);

} // namespace trembler::files
