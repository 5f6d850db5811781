#include "render/scene/substance.hpp"

namespace trembler::render {
namespace {

// Shades of the palette's materials that only scenes need.
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
        return {.material = Material::Stone, .tint = concrete};
    case Substance::brick:
        return {.material = Material::Stone, .tint = brick};
    case Substance::plastic:
        return {.material = Material::Plastic};
    case Substance::water:
        return {.material = Material::Water};
    case Substance::plain:
        break;
    }
    return {};
}

Substance substanceWithoutLook(bool fixed, bool conductor) {
    return conductor ? Substance::steel : (fixed ? Substance::stone : Substance::plastic);
}

SubstanceReader::SubstanceReader(World const&) {}

std::optional<Substance> SubstanceReader::of(ObjectId) const {
    return std::nullopt;
}

std::optional<Substance> substanceIn(Prototype const&) {
    return std::nullopt;
}

} // namespace trembler::render
