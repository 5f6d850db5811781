// The tools of the editor and the pages of its panel.
#pragma once

#include <cstdint>

namespace trembler::ui {

enum class Tool : std::uint8_t { select, box, disc, capsule, polygon, joint, wire, placing, goalArea };
enum class Tab : std::uint8_t {
    parts,
    outline,
    properties,
    goals,
    level,
    solutions,
    report,
    search,
    problems
};
enum class Alignment : std::uint8_t { left, right, top, bottom, column, row };

} // namespace trembler::ui
