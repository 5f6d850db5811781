#include "render/draw/style.hpp"

namespace trembler::render {

Colour colourOf(Material material) {
    switch (material) {
    case Material::Plain:
        return palette::plain;
    case Material::Metal:
        return palette::steel;
    case Material::Wood:
        return palette::wood;
    case Material::Glass:
        return palette::glass;
    case Material::Rubber:
        return palette::rubber;
    case Material::Stone:
        return palette::stone;
    case Material::Plastic:
        return palette::plastic;
    case Material::Copper:
        return palette::copper;
    case Material::Water:
        return palette::water;
    }
    return palette::plain;
}

} // namespace trembler::render
