// Annotations of the Lua Language Server about everything that scripts can read and call, for text editors.
#pragma once

#include "lua/reference/reference.hpp"

#include <filesystem>
#include <string>

namespace trembler::lua {

/// A file of definitions (`---@meta`), which is Lua itself.
[[nodiscard]] std::string annotationText(Reference const& reference);

/// Writes FOLDER/trembler.lua. Throws like writeFile().
void writeAnnotations(std::filesystem::path const& folder, Reference const& reference);

/// The settings of a mod's folder for the Lua Language Server: its Lua, and that only the names that
/// annotationText() defines exist.
[[nodiscard]] std::string editorSettings();

} // namespace trembler::lua
