// Making the components of mods known to a registry.
#pragma once

#include "lua/attach/live_script.hpp"
#include "lua/component/script_log.hpp"
#include "lua/mods/mod.hpp"
#include "runtime/world/registry.hpp"

#include <memory>
#include <span>

namespace trembler::lua {

/// Registers the property Scripts of a program without mods: levels that state it get a message.
void registerScripts(Registry& registry);

/// Registers the interactions of the mods after everything that is registered already, and the property
/// Scripts. Adds to `problems` all names in their scripts that the registry does not have. Returns the
/// scripts, which can be changed while worlds run; without mods there are none, and no component is
/// registered.
std::shared_ptr<LiveScripts const> registerMods(Registry& registry, std::span<Mod const> mods,
                                                std::shared_ptr<ScriptLog> const& log, Problems& problems);

} // namespace trembler::lua
