// The commands about the properties that scripts can read and the functions that they can call, which are
// part of `trembler mod`.
#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>

namespace trembler {

/// Adds `reference` and `annotations` to the command `mod`.
void addModReferenceCommands(CLI::App& mod, Work& work);

/// Writes into the folder of a mod the files that editors need to complete names: annotations/trembler.lua
/// and .luarc.json.
void writeEditorFiles(std::filesystem::path const& mod);

} // namespace trembler
