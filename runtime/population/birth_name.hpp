// What objects are called that are created while a world runs.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace trembler {

/// The name of an object made from `part`, the `number`th by the object `maker`: "PART of MAKER NUMBER", for
/// example "bullet of cannon 3". Where that name is taken, `attempt` is counted up from 1; from 2 on it
/// stands behind, in brackets: "bullet of cannon 3 (2)". Part and maker are names, so neither is empty.
[[nodiscard]] std::string birthName(std::string_view part, std::string_view maker, std::uint64_t number,
                                    std::uint64_t attempt = 1);

/// Whether birthName() can have made this name. A file or a command may speak of an object that does not
/// exist before the run, and this is all that can be checked of such a name then. An object that does exist
/// may have such a name, too: what an object is, its Origin says.
[[nodiscard]] bool isBirthName(std::string_view name);

} // namespace trembler
