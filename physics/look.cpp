#include "physics/look.hpp"

#include "physics/drawing.hpp"
#include "physics/look_form.hpp"
#include "runtime/world/registry.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler {
namespace {

bool isHexDigit(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

std::optional<std::string> checkLook(Store const& store, ObjectId id) {
    constexpr std::size_t colourLength = 7;
    constexpr std::size_t longestLabel = 16; // four characters of UTF-8
    Look const& look = (*store.findColumn<Look>())[id];
    if (!look.colour.empty() && (look.colour.size() != colourLength || look.colour[0] != '#' ||
                                 !std::all_of(look.colour.begin() + 1, look.colour.end(), isHexDigit))) {
        return fmt::format("the colour \"{}\" is none; expected six hexadecimal digits, \"#rrggbb\"",
                           look.colour);
    }
    auto const characters = std::count_if(look.label.begin(), look.label.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    });
    if (look.label.size() > longestLabel || characters > 4) {
        return "the label is too long; expected at most four characters";
    }
    return std::nullopt;
}

} // namespace

void registerLook(Registry& registry) {
    registry.property<Look>();
    registry.property<DrawnAs>();
    registerDrawing(registry);
    registry.rule({&propertyInfo<Look>(), checkLook});
}

} // namespace trembler
