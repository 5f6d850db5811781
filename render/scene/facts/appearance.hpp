// How objects of each material are drawn.
#pragma once

#include "physics/look.hpp"
#include "render/draw/style.hpp"

#include <optional>
#include <string_view>

namespace trembler::render {

/// The material of an object, in the words of the world; it is drawn with a Pattern.
using Substance = trembler::Material;

/// Metals are bolted down and carry windings; other fixed things are hatched like the ground.
[[nodiscard]] bool isMetal(Substance substance);
/// Pattern and colour.
[[nodiscard]] Style styleOf(Substance substance);
/// The guess for an object that states neither a material nor a pattern; `attracted` by magnets.
[[nodiscard]] Substance substanceWithoutLook(bool fixed, bool conductor, bool attracted);
/// "#rrggbb"; nothing for anything else.
[[nodiscard]] std::optional<Colour> colourFrom(std::string_view text);

} // namespace trembler::render
