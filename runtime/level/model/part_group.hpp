// The groups in which a large toolbox shows its parts.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace trembler {

/// A part may be in several: an electromagnet belongs to a circuit, and it is a magnet.
enum class PartGroup : std::uint8_t {
    electricity,
    magnets,
    mechanics,
    water,
    sound,
    structures,
    solids,
    mods
};

/// The names in part files, in the order of PartGroup.
inline constexpr std::array<std::string_view, 8> partGroupNames{
    "electricity", "magnets", "mechanics", "water", "sound", "structures", "solids", "mods"};

} // namespace trembler
