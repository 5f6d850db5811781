// The commands about what scripts can read and call, which are part of `trembler mod`.
#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>

namespace trembler {

/// Adds `reference` and `annotations` to the command `mod`.
void addModReferenceCommands(CLI::App& mod, int& result);

/// Writes into the folder of a mod what editors need to complete names: annotations/trembler.lua and
/// .luarc.json.
void writeEditorFiles(std::filesystem::path const& mod);

} // namespace trembler
