// The names of objects that are created while a world runs.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace trembler {

/// The name of an object made from `part`, the `number`th by the object `maker`: "PART of MAKER NUMBER", for
/// example "bullet of cannon 3". If that name is taken, `attempt` is counted up from 1; from 2 on it is
/// appended in brackets: "bullet of cannon 3 (2)". Part and maker are names, so neither is empty.
[[nodiscard]] std::string birthName(std::string_view part, std::string_view maker, std::uint64_t number,
                                    std::uint64_t attempt = 1);

/// Whether birthName() can have made this name. A file or a command may name an object that does not exist
/// before the run; such a name can only be checked for its form. Other objects may have names of this form,
/// too: an object's Origin states whether it is a birth.
[[nodiscard]] bool isBirthName(std::string_view name);

} // namespace trembler
