// The names that mods can have.
#pragma once

#include <string_view>

namespace trembler::lua {

/// Whether a mod can have that name: small letters, digits and -, at most 40, and no - in front.
[[nodiscard]] bool isModName(std::string_view name);

} // namespace trembler::lua
