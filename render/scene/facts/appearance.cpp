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
        return {.material = Material::Metal};
    case Substance::iron:
        return {.material = Material::Metal, .tint = iron};
    case Substance::copper:
        return {.material = Material::Copper};
    case Substance::gold:
        return {.material = Material::Copper, .tint = gold};
    case Substance::wood:
        return {.material = Material::Wood};
    case Substance::glass:
        return {.material = Material::Glass};
    case Substance::rubber:
        return {.material = Material::Rubber};
    case Substance::stone:
        return {.material = Material::Stone, .tint = concrete, .grain = 0.32};
    case Substance::brick:
        return {.material = Material::Stone, .tint = brick, .grain = 0.1};
    case Substance::plastic:
        return {.material = Material::Plastic};
    case Substance::water:
        return {.material = Material::Water};
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
