// The global functions of scripts: for vectors, numbers, texts and tables.
#pragma once

#include <span>
#include <string_view>

namespace trembler::lua {

struct GlobalNote {
    std::string_view name;   ///< "math.clamp"; of a method of vectors, "vec2:length"
    std::string_view use;    ///< "math.clamp(x, least, most)"
    std::string_view result; ///< the type of its result, or of itself, as editors write it; "" if it has none
    std::string_view meaning; ///< without a full stop
    std::string_view example; ///< statements that are true
    bool inApply = false;     ///< there only while `apply` runs, in which the example holds
};

/// In the order of the page. Complete: a test compares it with the globals of the sandbox, and with the
/// functions whose arguments the host checks.
[[nodiscard]] std::span<GlobalNote const> globalNotes();

} // namespace trembler::lua
