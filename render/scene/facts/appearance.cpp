#include "render/scene/facts/appearance.hpp"

#include <charconv>

namespace trembler::render {
namespace {

// Shades that only scenes need.
constexpr Colour iron = rgb(0x767B80);
constexpr Colour gold = rgb(0xDDA92B);
constexpr Colour brick = rgb(0xB8694D);
constexpr Colour concrete = rgb(0xC3B9AA);

} // namespace

bool isMetal(Substance substance) {
    return substance == Substance::steel || substance == Substance::iron || substance == Substance::copper ||
           substance == Substance::gold;
}

Style styleOf(Substance substance) {
    switch (substance) {
    case Substance::steel:
        return {.pattern = Pattern::Metal};
    case Substance::iron:
        return {.pattern = Pattern::Metal, .tint = iron};
    case Substance::copper:
        return {.pattern = Pattern::Copper};
    case Substance::gold:
        return {.pattern = Pattern::Copper, .tint = gold};
    case Substance::wood:
        return {.pattern = Pattern::Wood};
    case Substance::glass:
        return {.pattern = Pattern::Glass};
    case Substance::rubber:
        return {.pattern = Pattern::Rubber};
    case Substance::stone:
        return {.pattern = Pattern::Stone, .tint = concrete, .grain = 0.32};
    case Substance::brick:
        return {.pattern = Pattern::Stone, .tint = brick, .grain = 0.1};
    case Substance::plastic:
        return {.pattern = Pattern::Plastic};
    case Substance::water:
        return {.pattern = Pattern::Water};
    }
    return {};
}

Substance substanceWithoutLook(bool fixed, bool conductor, bool attracted) {
    if (attracted && !conductor) {
        return Substance::iron;
    }
    return conductor ? Substance::steel : (fixed ? Substance::stone : Substance::plastic);
}

std::optional<Colour> colourFrom(std::string_view text) {
    std::uint32_t value = 0;
    if (text.size() != 7 || text[0] != '#') {
        return std::nullopt;
    }
    auto const [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), value, 16);
    if (error != std::errc{} || end != text.data() + text.size()) {
        return std::nullopt;
    }
    return rgb(value);
}

} // namespace trembler::render
