#include "physics/drawing.hpp"

#include "physics/drawing_palette.hpp"
#include "runtime/level/json/suggestion.hpp"
#include "runtime/world/registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace trembler {
namespace {

using Flaw = std::optional<std::string>;

Flaw flawOfColour(std::string_view key, std::string const& colour) {
    if (colour.empty() || colourInDrawing(colour)) {
        return std::nullopt;
    }
    std::vector<std::string> names;
    for (NamedColour const& known : drawingPalette) {
        names.emplace_back(known.name);
    }
    return fmt::format("the {} \"{}\" is none{}; expected \"#rrggbb\", \"#rrggbbaa\" or one of: {}", key,
                       colour, didYouMean(colour, names), fmt::join(names, ", "));
}

double twiceAreaOf(std::vector<Vec2> const& corners) {
    double twice = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        Vec2 const a = corners[i];
        Vec2 const b = corners[(i + 1) % corners.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return std::abs(twice);
}

Flaw flawOf(DrawnShape const& shape, DrawnShape const* before) {
    for (auto const& [key, colour] : {std::pair<std::string_view, std::string const&>{"colour", shape.colour},
                                      {"outline_colour", shape.outlineColour},
                                      {"glow_colour", shape.glowColour}}) {
        if (Flaw flaw = flawOfColour(key, colour)) {
            return flaw;
        }
    }
    if (shape.form == DrawnForm::polygon) {
        std::size_t const corners = shape.corners.size();
        if (corners < 3 || corners > DrawnShape::mostCorners) {
            return fmt::format("it has {} corners; expected 3 to {}", corners, DrawnShape::mostCorners);
        }
        // A figure of eight may have the area 0 as well, and its inside is not defined.
        if (!(twiceAreaOf(shape.corners) > 1e-9)) {
            return "its corners enclose no area; expected a polygon";
        }
    }
    if (shape.form == DrawnForm::line &&
        (shape.points.size() < 2 || shape.points.size() > DrawnShape::mostCorners)) {
        return fmt::format("it has {} points; expected 2 to {}", shape.points.size(),
                           DrawnShape::mostCorners);
    }
    if (shape.form == DrawnForm::capsule && shape.width < 2 * shape.radius) {
        return fmt::format("its width, {} m, is less than that of its round ends; expected at least {} m",
                           shape.width, 2 * shape.radius);
    }
    if (shape.joined && (before == nullptr || !before->isArea())) {
        return "\"joined\" joins it with the area before it, but there is none; expected a box, circle, "
               "capsule "
               "or polygon before it";
    }
    return std::nullopt;
}

Flaw flawOf(Drawing const& drawing) {
    if (drawing.shapes.empty() || drawing.shapes.size() > Drawing::mostShapes) {
        return fmt::format("the drawing has {} shapes; expected 1 to {}", drawing.shapes.size(),
                           Drawing::mostShapes);
    }
    std::int32_t copies = 0;
    for (std::size_t i = 0; i < drawing.shapes.size(); ++i) {
        DrawnShape const& shape = drawing.shapes[i];
        copies += shape.repeat;
        if (Flaw const flaw = flawOf(shape, i == 0 ? nullptr : &drawing.shapes[i - 1])) {
            return fmt::format("shape {} of the drawing (a {}): {}", i + 1,
                               choiceNames<DrawnForm>[static_cast<std::size_t>(shape.form)], *flaw);
        }
    }
    if (copies > Drawing::mostCopies) {
        return fmt::format("the drawing has {} shapes with all repetitions; expected at most {}", copies,
                           Drawing::mostCopies);
    }
    return std::nullopt;
}

} // namespace

std::optional<std::uint32_t> colourInDrawing(std::string_view text) {
    auto const* const named = std::find_if(drawingPalette.begin(), drawingPalette.end(),
                                           [&](NamedColour const& known) { return known.name == text; });
    if (named != drawingPalette.end()) {
        return named->rgba;
    }
    constexpr std::size_t opaque = 7;
    constexpr std::size_t withOpacity = 9;
    std::uint32_t value = 0;
    if ((text.size() != opaque && text.size() != withOpacity) || text[0] != '#') {
        return std::nullopt;
    }
    char const* const last = text.data() + text.size();
    auto const [end, error] = std::from_chars(text.data() + 1, last, value, 16);
    if (error != std::errc{} || end != last) {
        return std::nullopt;
    }
    return text.size() == opaque ? (value << 8U) | 0xFFU : value;
}

void registerDrawing(Registry& registry) {
    registry.property<Drawing>();
    registry.rule({&propertyInfo<Drawing>(), [](Store const& store, ObjectId id) {
                       return flawOf((*store.findColumn<Drawing>())[id]);
                   }});
}

} // namespace trembler
