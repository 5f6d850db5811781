#include "render/draw/style.hpp"

namespace trembler::render {

Colour colourOf(Pattern pattern) {
    switch (pattern) {
    case Pattern::Plain:
        return palette::plain;
    case Pattern::Metal:
        return palette::steel;
    case Pattern::Wood:
        return palette::wood;
    case Pattern::Glass:
        return palette::glass;
    case Pattern::Rubber:
        return palette::rubber;
    case Pattern::Stone:
        return palette::stone;
    case Pattern::Plastic:
        return palette::plastic;
    case Pattern::Copper:
        return palette::copper;
    case Pattern::Water:
        return palette::water;
    }
    return palette::plain;
}

} // namespace trembler::render
