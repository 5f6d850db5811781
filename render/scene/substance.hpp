// What things are made of, to the eye.
#pragma once

#include "render/draw/style.hpp"
#include "runtime/world/world.hpp"

#include <cstdint>
#include <optional>

namespace trembler::render {

enum class Substance : std::uint8_t {
    plain,
    steel,
    iron,
    copper,
    wood,
    glass,
    rubber,
    stone,
    plastic,
    brick,
    water,
    gold,
};

/// Metals carry bolts and windings; other fixed things are hatched like the ground.
[[nodiscard]] bool isMetal(Substance substance);
/// Pattern and colour.
[[nodiscard]] Style styleOf(Substance substance);
/// The guess for an object that does not state its look.
[[nodiscard]] Substance substanceWithoutLook(bool fixed, bool conductor);

/// Reads the looks of many objects of a world.
class SubstanceReader {
public:
    explicit SubstanceReader(World const& world);
    /// Nothing for an object that does not state its look.
    [[nodiscard]] std::optional<Substance> of(ObjectId id) const;
};
[[nodiscard]] std::optional<Substance> substanceIn(Prototype const& prototype);

} // namespace trembler::render
