// Making the components of mods known to a registry.
#pragma once

#include "lua/component/script_log.hpp"
#include "lua/mods/mod.hpp"
#include "runtime/world/registry.hpp"

#include <memory>
#include <span>

namespace trembler::lua {

/// Registers the interactions of the mods after all that is registered already, and the property Scripts.
/// Adds to `problems` what their scripts name and the registry has not. Without mods it changes nothing.
void registerMods(Registry& registry, std::span<Mod const> mods, std::shared_ptr<ScriptLog> const& log,
                  Problems& problems);

} // namespace trembler::lua
