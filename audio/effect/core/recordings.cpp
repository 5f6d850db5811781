#include "audio/effect/core/recordings.hpp"

#include "audio/effect/hearing/smoothing.hpp"
#include "audio/effect/properties/decibel.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace trembler {
namespace {

constexpr std::ptrdiff_t mostGoes = 4; // of one object at a time; beyond, the oldest ends

void begin(Sounds& sounds, Sample const& sample, ObjectId object, double share, bool held, EventId event) {
    Sounds::Recording fresh;
    fresh.object = object;
    fresh.file = sample.file;
    fresh.meanSquare = meanSquareOf(sample.level) * share;
    fresh.duration = sample.duration;
    fresh.held = held;
    fresh.serial = ++sounds.recordingsEver;
    fresh.event = event;
    auto const from = std::find_if(sounds.recordings.begin(), sounds.recordings.end(),
                                   [&](Sounds::Recording const& r) { return !(r.object < object); });
    auto const to = std::find_if(from, sounds.recordings.end(),
                                 [&](Sounds::Recording const& r) { return object < r.object; });
    bool const full = to - from >= mostGoes;
    sounds.recordings.insert(to, std::move(fresh));
    if (full) {
        auto const oldest =
            std::find_if(sounds.recordings.begin(), sounds.recordings.end(),
                         [&](Sounds::Recording const& r) { return r.object == object && !r.held; });
        sounds.recordings.erase(oldest);
    }
}

void beginAsked(SoundColumns const& columns, SoundCalls const& calls, Sounds& sounds) {
    std::map<ObjectId, Received<PlaySample>> plays;
    for (Received<PlaySample> const& received : calls.plays) {
        if (received.call.share > 0) {
            auto const [at, isNew] = plays.emplace(received.call.object, received);
            at->second.call.share += isNew ? 0 : received.call.share;
        }
    }
    for (auto const& [object, received] : plays) {
        if (Sample const* const sample = columns.sample.find(object)) {
            begin(sounds, *sample, object, std::min(received.call.share, 1.0), false, received.cause);
        }
    }
    std::map<ObjectId, EventId> holds;
    for (Received<HoldSample> const& received : calls.holds) {
        holds.emplace(received.call.object, received.cause);
    }
    for (Sounds::Recording& recording : sounds.recordings) {
        if (recording.held && holds.erase(recording.object) == 0) {
            recording.held = false; // no longer held: it ends now
            recording.elapsed = recording.duration;
        }
    }
    for (auto const& [object, cause] : holds) {
        if (Sample const* const sample = columns.sample.find(object)) {
            begin(sounds, *sample, object, 1, true, cause);
        }
    }
}

} // namespace

void advanceRecordings(SoundColumns const& columns, SoundCalls const& calls, double duration,
                       Sounds& sounds) {
    std::erase_if(sounds.recordings, [&](Sounds::Recording const& recording) {
        return !columns.sample.has(recording.object) || !columns.position.has(recording.object);
    });
    beginAsked(columns, calls, sounds);
    for (Sounds::Recording& recording : sounds.recordings) {
        double const playing =
            recording.held ? duration : std::clamp(recording.duration - recording.elapsed, 0.0, duration);
        recording.elapsed += duration;
        smooth(recording.loudness, recording.meanSquare * playing / duration, duration);
        recording.at = columns.position[recording.object].value;
        Velocity const* const velocity = columns.velocity.find(recording.object);
        recording.velocity = velocity == nullptr ? Vec2{} : velocity->value;
    }
    std::erase_if(sounds.recordings, [](Sounds::Recording const& recording) {
        return !recording.held && recording.elapsed >= recording.duration && recording.loudness < inaudible;
    });
}

} // namespace trembler
