#include "audio/effect/loudness.hpp"

#include "audio/effect/acoustic_material.hpp"
#include "audio/effect/decibel.hpp"
#include "audio/effect/smoothing.hpp"

#include <algorithm>
#include <iterator>

namespace trembler {
namespace {

struct Source {
    ObjectId object;
    Vec2 at;
    double loudness = 0;  // Pa² at 1 m
    double frequency = 0; // Hz
    EventId event;
};

std::vector<Source> sourcesOf(Sounds const& sounds) {
    constexpr double typical = 1000; // Hz, of a recording
    std::vector<Source> sources;
    for (Sounds::Body const& body : sounds.bodies) {
        if (body.loudness > inaudible) {
            sources.push_back({body.object, body.at, body.loudness, body.brightness, body.event});
        }
    }
    for (Sounds::Recording const& recording : sounds.recordings) {
        if (recording.loudness > inaudible) {
            sources.push_back({recording.object, recording.at, recording.loudness, typical, recording.event});
        }
    }
    return sources;
}

std::vector<Obstacle> obstaclesOf(LoudnessColumns const& columns) {
    std::vector<Obstacle> obstacles;
    for (std::size_t row = 0; row < columns.shape.size(); ++row) {
        ObjectId const id = columns.shape.owners()[row];
        Position const* const position = columns.position.find(id);
        if (position == nullptr) {
            continue;
        }
        Rotation const* const rotation = columns.rotation.find(id);
        Density const* const density = columns.density.find(id);
        Look const* const look = columns.look.find(id);
        Material const material = look == nullptr ? Material::plastic : look->material;
        addObstacles(obstacles, id, columns.shape.values()[row], position->value,
                     rotation == nullptr ? 0 : rotation->angle,
                     density == nullptr ? acousticMaterial(material).density : density->value);
    }
    return obstacles;
}

} // namespace

double Loudness::at(ObjectId ear) const {
    auto const found = std::lower_bound(entries.begin(), entries.end(), ear,
                                        [](Entry const& entry, ObjectId id) { return entry.ear < id; });
    return found != entries.end() && found->ear == ear ? found->level : silentLevel;
}

std::vector<Loudness::Entry> loudnessOf(Sounds const& sounds, LoudnessColumns const& columns,
                                        PathDetail detail) {
    constexpr double margin = 0.01; // 20 dB
    std::vector<ObjectId> ears;
    std::set_union(columns.ears.owners().begin(), columns.ears.owners().end(),
                   columns.sensors.owners().begin(), columns.sensors.owners().end(),
                   std::back_inserter(ears));
    std::vector<Source> const sources = sourcesOf(sounds);
    std::vector<Obstacle> obstacles;
    if (!sources.empty()) {
        obstacles = obstaclesOf(columns);
    }
    std::vector<Loudness::Entry> entries;
    for (ObjectId const ear : ears) {
        Loudness::Entry entry{ear, silentLevel, {}, {}};
        Position const* const position = columns.position.find(ear);
        SoundSensor const* const sensor = columns.sensors.find(ear);
        bool const onlySwitches = sensor != nullptr && !columns.ears.has(ear);
        double const faintest = onlySwitches ? margin * meanSquareOf(sensor->threshold) : inaudible;
        double sum = 0;
        double most = 0;
        for (Source const& source : sources) {
            if (position == nullptr) {
                break;
            }
            double const free = source.loudness / std::max(0.01, lengthSquared(position->value - source.at));
            if (free < faintest) {
                continue;
            }
            double const share = transmission(obstacles, std::span(&ear, 1), source.at, position->value,
                                              source.frequency, detail);
            double const heard = source.loudness * share;
            sum += heard;
            if (heard > most) {
                most = heard;
                entry.loudest = source.object;
                entry.event = source.event;
            }
        }
        entry.level = levelOf(sum);
        entries.push_back(entry);
    }
    return entries;
}

bool StraightLoudness::suits(Store const& store) {
    constexpr std::size_t many = 400;
    auto const size = [](auto const* column) { return column == nullptr ? 0 : column->size(); };
    std::size_t const ears = size(store.findColumn<Ear>()) + size(store.findColumn<SoundSensor>());
    return size(store.findColumn<Shape>()) * ears > many;
}

} // namespace trembler
