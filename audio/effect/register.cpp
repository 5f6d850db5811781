#include "audio/effect/register.hpp"

#include "audio/effect/core/sound_resolver.hpp"
#include "audio/effect/hearing/loudness.hpp"
#include "audio/effect/interactions/electricity_from_sound.hpp"
#include "audio/effect/interactions/from_buoyancy.hpp"
#include "audio/effect/interactions/from_dynamics.hpp"
#include "audio/effect/interactions/from_electricity.hpp"
#include "runtime/world/registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace trembler {
namespace {

// A level may be from an untrusted source: its recordings must be files in its folder or in the program's.
std::optional<std::string> checkSample(Store const& store, ObjectId id) {
    constexpr std::array<std::string_view, 3> endings{".ogg", ".wav", ".flac"};
    std::string const& file = store.findColumn<Sample>()->find(id)->file;
    bool const known = std::any_of(endings.begin(), endings.end(),
                                   [&](std::string_view ending) { return file.ends_with(ending); });
    bool const plain = file.find_first_of("\\:") == std::string::npos &&
                       file.find('\0') == std::string::npos && !file.starts_with('/') &&
                       file.find("..") == std::string::npos;
    if (!known || !plain) {
        return fmt::format(
            "\"{}\" cannot be a recording; expected the name of an .ogg, .wav or .flac file, without "
            "'..' and not from the root",
            file);
    }
    return std::nullopt;
}

std::optional<std::string> checkSensor(Store const& store, ObjectId id) {
    SoundSensor const& sensor = *store.findColumn<SoundSensor>()->find(id);
    if (!sensor.a.valid() && !sensor.b.valid()) {
        return std::nullopt;
    }
    auto const* const conductors = store.findColumn<Conductor>();
    auto const conducts = [&](ObjectId end) { return conductors != nullptr && conductors->has(end); };
    if (!sensor.a.valid() || !sensor.b.valid() || sensor.a == sensor.b) {
        return "the sensor names one end only; expected two different objects, \"from\" and \"to\", or "
               "neither";
    }
    for (ObjectId const end : {sensor.a, sensor.b}) {
        if (!conducts(end)) {
            return fmt::format("'{}' is no conductor; expected an object with the property '{}'",
                               store.nameOf(end), Conductor::text.key);
        }
    }
    return std::nullopt;
}

} // namespace

void registerSound(Registry& registry) {
    for (SoundLevel const& level : soundLevels) {
        registry.component<SoundResolver>(level);
    }
    registry.component<StraightLoudness>();
    registry.component<AroundLoudness>();
    registry.component<SoundFromDynamics>();
    registry.component<SoundFromElectricity>();
    registry.component<SoundFromBuoyancy>();
    registry.component<ElectricityFromSound>();
    registry.rule({&propertyInfo<Sample>(), checkSample});
    registry.rule({&propertyInfo<SoundSensor>(), checkSensor});
}

} // namespace trembler
