#include "audio/effect/hearing/loudness.hpp"

#include "audio/effect/hearing/heard_sum.hpp"
#include "audio/effect/hearing/smoothing.hpp"
#include "audio/effect/properties/decibel.hpp"
#include "physics/dynamics/properties/shapes/mass_properties.hpp"

#include <algorithm>
#include <iterator>

namespace trembler {
namespace {

/// The path from a source to a listener.
struct Way {
    SoundSource const* source;
    Vec2 to;          // m
    std::size_t ear;  // the listener's entry
    double heard = 0; // Pa²
};

// Paths whose sum is less than 2^-60 of silence change no level: a million of them at 2^-80.
constexpr double withoutEffect = 0x1p-80;

// There are sources times ears of these; this many at a time are kept in memory.
constexpr std::size_t waysAtOnce = 1 << 18;

std::vector<SoundSource> sourcesOf(Sounds const& sounds) {
    constexpr double typical = 1000; // Hz, of a recording
    std::vector<SoundSource> sources;
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

std::vector<SoundListener> listeningIn(LoudnessColumns const& columns) {
    constexpr double margin = 0.01; // 20 dB
    std::vector<ObjectId> ears;
    std::set_union(columns.ears.owners().begin(), columns.ears.owners().end(),
                   columns.sensors.owners().begin(), columns.sensors.owners().end(),
                   std::back_inserter(ears));
    std::vector<SoundListener> all;
    for (ObjectId const ear : ears) {
        Position const* const position = columns.position.find(ear);
        SoundSensor const* const sensor = columns.sensors.find(ear);
        bool const onlySwitches = sensor != nullptr && !columns.ears.has(ear);
        all.push_back({ear, position != nullptr, position == nullptr ? Vec2{} : position->value,
                       onlySwitches ? margin * meanSquareOf(sensor->threshold) : inaudible});
    }
    return all;
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
        Shape const& shape = columns.shape.values()[row];
        addObstacles(obstacles, id, shape, position->value, rotation == nullptr ? 0 : rotation->angle,
                     densityOf(shape, columns.mass.find(id), columns.density.find(id)));
    }
    return obstacles;
}

// The number of paths around obstacles grows with the sources times the ears, and the cost of each with the
// obstacles. This limits the work of a frame: with very many objects only the simpler paths are found, and
// otherwise the straight line through the walls counts. The limit depends on numbers of objects alone, so it
// is the same in every run.
int patienceFor(std::size_t ways, std::size_t obstacles) {
    constexpr double chords = 5e6; // of obstacles, tested in one frame
    double const each = chords / (static_cast<double>(ways) * std::max(1.0, static_cast<double>(obstacles)));
    return static_cast<int>(std::clamp(each, 20.0, static_cast<double>(mostPatience)));
}

// `ways` contains either all ways of an ear or none.
void addUp(std::vector<Way> const& ways, std::vector<Loudness::Entry>& entries) {
    for (auto way = ways.begin(); way != ways.end();) {
        Loudness::Entry& entry = entries[way->ear];
        double sum = 0;
        double most = 0;
        for (std::size_t const ear = way->ear; way != ways.end() && way->ear == ear; ++way) {
            sum += way->heard;
            if (way->heard > most) {
                most = way->heard;
                entry.loudest = way->source->object;
                entry.event = way->source->event;
            }
        }
        entry.level = levelOf(sum);
    }
}

void hearAround(std::span<SoundSource const> sources, std::span<SoundListener const> ears,
                LoudnessColumns const& columns, ForPaths const& forPaths,
                std::vector<Loudness::Entry>& entries) {
    std::size_t count = 0; // number of all ways
    for (SoundListener const& ear : ears) {
        count += static_cast<std::size_t>(std::count_if(
            sources.begin(), sources.end(), [&](SoundSource const& source) { return reaches(source, ear); }));
    }
    if (count == 0) {
        return;
    }
    std::vector<Obstacle> const obstacles = obstaclesOf(columns);
    ObstacleField const field(obstacles);
    int const patience = patienceFor(count, obstacles.size());
    std::vector<Way> ways; // by ear, and of each ear in order of sources
    for (std::size_t ear = 0; ear < ears.size(); ++ear) {
        for (SoundSource const& source : sources) {
            if (reaches(source, ears[ear])) {
                ways.push_back({&source, ears[ear].at, ear, 0});
            }
        }
        if (ways.empty() || (ways.size() < waysAtOnce && ear + 1 < ears.size())) {
            continue;
        }
        forPaths(ways.size(), [&](std::size_t begin, std::size_t end) {
            for (Way& way : std::span(ways).subspan(begin, end - begin)) {
                way.heard = way.source->loudness * transmission(field, std::span(&entries[way.ear].ear, 1),
                                                                way.source->at, way.to, way.source->frequency,
                                                                PathDetail::around, 0, patience);
            }
        });
        addUp(ways, entries);
        ways.clear();
    }
}

// Each ear asks for some ways at a time. They are computed for many ears together, to be divided among
// threads even if there are few ears.
void hearStraight(std::span<SoundSource const> sources, std::span<SoundListener const> ears,
                  LoudnessColumns const& columns, ForPaths const& forPaths,
                  std::span<Loudness::Entry> entries) {
    constexpr std::size_t mostTogether = 512;
    double const silence = withoutEffect * meanSquareOf(silentLevel);
    SourceTree const tree(sources);
    std::size_t const together =
        std::clamp(waysAtOnce / std::max(std::size_t{1}, sources.size()), std::size_t{1}, mostTogether);
    std::vector<HeardSum> sums(std::min(together, ears.size()));
    if (std::none_of(ears.begin(), ears.end(),
                     [&](SoundListener const& ear) { return sums.front().begin(ear, tree, silence); })) {
        return;
    }
    std::vector<Obstacle> const obstacles = obstaclesOf(columns);
    ObstacleField const field(obstacles);
    struct Asked {
        HeardSum const* sum;
        HeardSum::Way* way;
    };
    std::vector<Asked> asked;
    std::vector<HeardSum*> unfinished;
    for (std::size_t first = 0; first < ears.size(); first += together) {
        std::size_t const count = std::min(together, ears.size() - first);
        unfinished.clear();
        for (std::size_t i = 0; i < count; ++i) {
            if (sums[i].begin(ears[first + i], tree, silence)) {
                unfinished.push_back(&sums[i]);
            }
        }
        while (!unfinished.empty()) {
            forPaths(unfinished.size(), [&](std::size_t begin, std::size_t end) {
                for (HeardSum*& sum : std::span(unfinished).subspan(begin, end - begin)) {
                    if (!sum->next(tree, field)) {
                        Loudness::Entry& entry = entries[first + static_cast<std::size_t>(sum - sums.data())];
                        entry.level = levelOf(sum->sum());
                        if (std::optional<std::uint32_t> const loudest = sum->loudest()) {
                            entry.loudest = sources[*loudest].object;
                            entry.event = sources[*loudest].event;
                        }
                        sum = nullptr;
                    }
                }
            });
            std::erase(unfinished, nullptr);
            asked.clear();
            for (HeardSum* const sum : unfinished) {
                for (HeardSum::Way& way : sum->ways()) {
                    asked.push_back({sum, &way});
                }
            }
            forPaths(asked.size(), [&](std::size_t begin, std::size_t end) {
                for (auto const& [sum, way] : std::span(asked).subspan(begin, end - begin)) {
                    SoundSource const& source = sources[way->source];
                    way->heard =
                        source.loudness * transmission(field, std::span(&sum->listener().object, 1),
                                                       source.at, sum->listener().at, source.frequency,
                                                       PathDetail::straight, sum->least() / source.loudness);
                }
            });
        }
    }
}

} // namespace

std::vector<Loudness::Entry> loudnessOf(Sounds const& sounds, LoudnessColumns const& columns,
                                        PathDetail detail, ForPaths const& forPaths) {
    std::vector<SoundSource> const sources = sourcesOf(sounds);
    std::vector<SoundListener> const ears = listeningIn(columns);
    std::vector<Loudness::Entry> entries;
    entries.reserve(ears.size());
    for (SoundListener const& ear : ears) {
        entries.push_back({ear.object, silentLevel, {}, {}});
    }
    if (ears.empty() || sources.empty()) {
        return entries;
    }
    if (detail == PathDetail::straight) {
        hearStraight(sources, ears, columns, forPaths, entries);
    } else {
        hearAround(sources, ears, columns, forPaths, entries);
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
