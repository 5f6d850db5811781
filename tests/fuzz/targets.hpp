// What is fuzzed: libFuzzer calls these with inputs that it invents, and a test with those that are kept.
#pragma once

#include <string>
#include <string_view>

namespace trembler::lua {

/// Takes the bytes for the text of a script: of a whole one if it says 'interaction', else of what one's
/// apply contains. Reads it and, if nothing is wrong with it, runs it in a world beside another script.
void fuzzScriptText(std::string_view bytes);

/// Makes a script out of the bytes that calls functions of a resolver with arguments of all kinds, right and
/// wrong ones, for objects that live or are gone, and runs it in a world.
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
