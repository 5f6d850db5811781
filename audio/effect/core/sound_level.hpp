// The detail levels of Sound: the number of modes of each body.
#pragma once

#include "audio/effect/core/sounding_body.hpp"
#include "audio/effect/properties/acoustics.hpp"
#include "physics/material.hpp"
#include "runtime/component/info.hpp"
#include "runtime/world/store.hpp"

#include <array>

namespace trembler {

/// The value with which a SoundResolver is registered; a constant, as it must outlive every registry.
struct SoundLevel {
    ComponentText text;
    int modes = 1;                         ///< per body, 1 to mostModes
    bool (*suits)(Store const&) = nullptr; ///< see Registration
};

/// The number of objects that can sound.
[[nodiscard]] inline std::size_t soundingObjects(Store const& store) {
    auto const* const madeOf = store.findColumn<MadeOf>();
    return madeOf == nullptr ? 0 : madeOf->size();
}

/// Eight modes are enough for most listeners; scenes of very many bodies use fewer.
inline constexpr std::array<SoundLevel, 5> soundLevels{
    SoundLevel{
        .text{.name = "Sound, 1 mode",
              .effect = "sound",
              .level = "1-mode",
              .work = "Impacts and rubbing excite the modes of bodies, which decay. One mode per body.",
              .rank = 1},
        .modes = 1,
        .suits = [](Store const& store) { return soundingObjects(store) > 5000; }},
    SoundLevel{
        .text{.name = "Sound, 4 modes",
              .effect = "sound",
              .level = "4-modes",
              .work = "Impacts and rubbing excite the modes of bodies, which decay. Four modes per body.",
              .rank = 2},
        .modes = 4,
        .suits = [](Store const& store) { return soundingObjects(store) > 1000; }},
    SoundLevel{
        .text{.name = "Sound, 8 modes",
              .effect = "sound",
              .level = "8-modes",
              .work = "Impacts and rubbing excite the modes of bodies, which decay. Eight modes per body.",
              .rank = 3},
        .modes = 8},
    SoundLevel{
        .text{.name = "Sound, 16 modes",
              .effect = "sound",
              .level = "16-modes",
              .work = "Impacts and rubbing excite the modes of bodies, which decay. Sixteen modes per body.",
              .rank = 4},
        .modes = 16},
    SoundLevel{
        .text{.name = "Sound, 32 modes",
              .effect = "sound",
              .level = "32-modes",
              .work = "Impacts and rubbing excite the modes of bodies, which decay. Up to 32 modes per body.",
              .rank = 5},
        .modes = mostModes},
};

} // namespace trembler
