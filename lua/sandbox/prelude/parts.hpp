// The parts of the prelude's text, by theme. They are one chunk: each uses the local variables of those
// before it.
#pragma once

#include <string_view>

namespace trembler::lua {

[[nodiscard]] std::string_view foundationsPart();
[[nodiscard]] std::string_view errorsPart();
[[nodiscard]] std::string_view vectorsPart();
[[nodiscard]] std::string_view readingsPart();
[[nodiscard]] std::string_view textPart();
[[nodiscard]] std::string_view tablesPart();
[[nodiscard]] std::string_view numbersPart();
[[nodiscard]] std::string_view globalsPart();

} // namespace trembler::lua
