// The colours that a drawing can name. Okabe and Ito's rule holds for them as for the rest of the program:
// colours that the player has to distinguish differ in lightness, too.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace trembler {

struct NamedColour {
    std::string_view name;
    std::uint32_t rgba = 0; ///< 0xRRGGBBAA
};

inline constexpr std::array drawingPalette{
    NamedColour{"ink", 0x2E2925FF},       NamedColour{"soft_ink", 0x6B6157FF},
    NamedColour{"paper", 0xF4ECDDFF},     NamedColour{"white", 0xFBF7EEFF},
    NamedColour{"cream", 0xE7DBC5FF},     NamedColour{"grey", 0xA79E92FF},
    NamedColour{"steel", 0x9CA9B5FF},     NamedColour{"iron", 0x767B80FF},
    NamedColour{"dark", 0x45434AFF},      NamedColour{"brass", 0xC9A860FF},
    NamedColour{"gold", 0xDDA92BFF},      NamedColour{"copper", 0xC9713DFF},
    NamedColour{"rope", 0xB79B6CFF},      NamedColour{"wood", 0xC8945AFF},
    NamedColour{"dark_wood", 0x8A5E34FF}, NamedColour{"brick", 0xB8694DFF},
    NamedColour{"red", 0xD5502BFF},       NamedColour{"rust", 0xBC4B00FF},
    NamedColour{"yellow", 0xFFB000FF},    NamedColour{"glow", 0xFFF3C4FF},
    NamedColour{"green", 0x00805FFF},     NamedColour{"olive", 0x7A8F3CFF},
    NamedColour{"blue", 0x2F6FB5FF},      NamedColour{"sky", 0x7FB7D9FF},
    NamedColour{"purple", 0x8A3FA0FF},    NamedColour{"plastic", 0xE2B33CFF},
    NamedColour{"glass", 0xA8DCE246},     NamedColour{"water", 0x2E8AD0A5},
};

/// 0xRRGGBBAA of "#rrggbb", "#rrggbbaa" or a name of the palette; nothing for anything else.
[[nodiscard]] std::optional<std::uint32_t> colourInDrawing(std::string_view text);

} // namespace trembler
