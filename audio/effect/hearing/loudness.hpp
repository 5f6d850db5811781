// Computes the loudness at listening objects.
#pragma once

#include "audio/effect/hearing/sound_path.hpp"
#include "audio/effect/properties/acoustics.hpp"
#include "audio/effect/properties/loudness.hpp"
#include "audio/effect/properties/sounds.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "runtime/component/dps.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/store.hpp"

#include <cstdint>
#include <functional>

namespace trembler {

/// The columns from which loudness is computed.
struct LoudnessColumns {
    Column<Ear> const& ears;
    Column<SoundSensor> const& sensors;
    Column<Shape> const& shape;
    Column<Mass> const& mass;
    Column<Density> const& density;
    Column<Position> const& position;
    Column<Rotation> const& rotation;
};

/// Calls f(begin, end) for ranges that cover [0, count), perhaps at the same time.
using ForPaths =
    std::function<void(std::size_t count, std::function<void(std::size_t, std::size_t)> const& f)>;

/// Every source counts by its A-weighted energy, with the share that air and walls transmit. Sources more
/// than 20 dB below the faintest level relevant to a listener are left out. `forPaths` iterates over the ways
/// from sources to listeners; no result depends on it.
[[nodiscard]] std::vector<Loudness::Entry> loudnessOf(Sounds const& sounds, LoudnessColumns const& columns,
                                                      PathDetail detail, ForPaths const& forPaths);

/// `Self` adds `text` and `static constexpr PathDetail detail`.
template <class Self>
class LoudnessDps
    : public Dps<Self, Reads<Sounds, Ear, SoundSensor, Shape, Mass, Density, Position, Rotation>,
                 Derives<Loudness>> {
    using Base = Dps<Self, Reads<Sounds, Ear, SoundSensor, Shape, Mass, Density, Position, Rotation>,
                     Derives<Loudness>>;

public:
    using Activation = NeedsAny<Ear, SoundSensor>;
    using Access = typename Base::Access;
    static constexpr std::size_t waysToARange = 8;

    void update(Access& access) {
        std::vector<Loudness::Entry> entries = loudnessOf(
            access.template read<Sounds>(),
            {access.template read<Ear>(), access.template read<SoundSensor>(), access.template read<Shape>(),
             access.template read<Mass>(), access.template read<Density>(), access.template read<Position>(),
             access.template read<Rotation>()},
            Self::detail,
            [&](std::size_t count, auto const& f) { access.forRanges(count, f, waysToARange); });
        auto const& before = access.template derived<Loudness>().entries;
        bool const same =
            std::equal(entries.begin(), entries.end(), before.begin(), before.end(),
                       [](Loudness::Entry const& a, Loudness::Entry const& b) {
                           return a.ear == b.ear && a.level == b.level && a.loudest == b.loudest;
                       });
        if (!same) {
            access.template derive<Loudness>().entries = std::move(entries);
        }
    }
};

class StraightLoudness final : public LoudnessDps<StraightLoudness> {
public:
    static constexpr PathDetail detail = PathDetail::straight;
    static constexpr ComponentText text{
        .name = "Straight Loudness",
        .effect = "loudness",
        .level = "straight",
        .work =
            "Adds up, for every listening object, the sounds that reach it along straight lines: weakened by "
            "the distance and by walls, through them according to their mass, and around each of them.",
        .rank = 1};
    /// Not for scenes with very many obstacles or listeners, in which ways around all obstacles are too
    /// expensive.
    static bool suits(Store const& store);
};

class AroundLoudness final : public LoudnessDps<AroundLoudness> {
public:
    static constexpr PathDetail detail = PathDetail::around;
    static constexpr ComponentText text{
        .name = "Loudness around Corners",
        .effect = "loudness",
        .level = "around",
        .work =
            "Adds up, for every listening object, the sounds that reach it: weakened by the distance and by "
            "walls, through them according to their mass, and along the shortest path around all of them.",
        .rank = 2};
};

} // namespace trembler
