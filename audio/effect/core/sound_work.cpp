#include "audio/effect/core/sound_work.hpp"

#include "audio/effect/core/contact_pulse.hpp"
#include "audio/effect/core/recordings.hpp"
#include "audio/effect/hearing/smoothing.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

/// A quantity that decays like e^(-rate t) over `time` s, from 1.
struct Decay {
    Decay(double rate, double time) {
        double const x = rate * time;
        rest = std::exp(-x);
        mean = x > 1e-3 ? (1 - rest) / x : 1 - x / 2 + x * x / 6;
    }
    double rest; ///< at the end
    double mean;
};

bool isSane(Strike const& call) {
    return isFinite(call.point) && isFinite(call.normal) && std::isfinite(call.impulse) && call.impulse > 0 &&
           std::isfinite(call.contact) && call.contact >= 0 && std::isfinite(call.since);
}
bool isSane(Rub const& call) {
    return isFinite(call.point) && isFinite(call.normal) && std::isfinite(call.force) && call.force > 0 &&
           std::isfinite(call.bandwidth) && call.bandwidth > 0;
}

Vec2 inWorld(SoundColumns const& columns, ObjectId id, Vec2 local) {
    Position const* const position = columns.position.find(id);
    Rotation const* const rotation = columns.rotation.find(id);
    return (position == nullptr ? Vec2{} : position->value) +
           rotated(local, rotation == nullptr ? 0 : rotation->angle);
}

} // namespace

void SoundCalls::clear() {
    strikes.clear();
    rubs.clear();
    plays.clear();
    holds.clear();
}

bool SoundWork::goesOn(Sounds const& sounds) {
    return !sounds.silent() || !sounds.impacts.empty() || !sounds.scrapes.empty();
}

void SoundWork::advance(SoundColumns const& columns, SoundCalls const& calls, double duration,
                        Sounds& sounds) {
    fit(columns, sounds);
    sounds.impacts.clear();
    sounds.scrapes.clear();
    sounds.amplitudes.clear();
    findExcited(columns, calls, sounds);
    for (Received<Strike> const& received : calls.strikes) {
        strike(columns, received, duration, sounds);
    }
    for (Received<Rub> const& received : calls.rubs) {
        rub(columns, received, duration, sounds);
    }
    dieAway(duration, sounds);
    place(columns, sounds);
    advanceRecordings(columns, calls, duration, sounds);
}

// Removes destroyed bodies. Bodies that ring with another number of modes, or whose modes have changed,
// continue with the present modes.
void SoundWork::fit(SoundColumns const& columns, Sounds& sounds) {
    std::erase_if(sounds.bodies,
                  [&](Sounds::Body const& body) { return models_.find(columns, body.object) == nullptr; });
    for (Sounds::Body& body : sounds.bodies) {
        std::vector<Mode> const& modes = models_.find(columns, body.object)->modes();
        body.rings.resize(modes.size());
        for (std::size_t i = 0; i < modes.size(); ++i) {
            Sounds::Ring& ring = body.rings[i];
            ring = {modes[i].frequency, modes[i].decay, ring.meanSquare, modes[i].audibility};
        }
    }
}

// Adds the objects that begin to sound to `sounds`, all at once, as there can be many.
void SoundWork::findExcited(SoundColumns const& columns, SoundCalls const& calls, Sounds& sounds) {
    std::vector<ObjectId> objects;
    for (Received<Strike> const& received : calls.strikes) {
        if (isSane(received.call)) {
            objects.push_back(received.call.object);
        }
    }
    for (Received<Rub> const& received : calls.rubs) {
        if (isSane(received.call)) {
            objects.push_back(received.call.object);
        }
    }
    std::sort(objects.begin(), objects.end());
    objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
    excited_.clear();
    left_.clear();
    std::vector<Sounds::Body> merged;
    merged.reserve(sounds.bodies.size() + objects.size());
    auto known = sounds.bodies.begin();
    for (ObjectId const object : objects) {
        Excited entry;
        entry.object = object;
        entry.model = models_.find(columns, object);
        if (entry.model == nullptr) {
            continue;
        }
        entry.first = left_.size();
        left_.resize(left_.size() + entry.model->modes().size(), 0);
        excited_.push_back(entry);
        for (; known != sounds.bodies.end() && known->object < object; ++known) {
            merged.push_back(std::move(*known));
        }
        if (known != sounds.bodies.end() && known->object == object) {
            merged.push_back(std::move(*known++));
            continue;
        }
        Sounds::Body& fresh = merged.emplace_back();
        fresh.object = object;
        fresh.rings.reserve(entry.model->modes().size());
        for (Mode const& mode : entry.model->modes()) {
            fresh.rings.push_back({mode.frequency, mode.decay, 0, mode.audibility});
        }
    }
    if (excited_.empty()) {
        return;
    }
    std::move(known, sounds.bodies.end(), std::back_inserter(merged));
    sounds.bodies = std::move(merged);
    auto body = sounds.bodies.begin();
    for (Excited& entry : excited_) {
        while (body->object != entry.object) {
            ++body;
        }
        entry.body = &*body;
    }
}

SoundWork::Excited* SoundWork::excited(ObjectId object) {
    auto const at = std::lower_bound(excited_.begin(), excited_.end(), object,
                                     [](Excited const& entry, ObjectId id) { return entry.object < id; });
    return at != excited_.end() && at->object == object ? &*at : nullptr;
}

void SoundWork::strike(SoundColumns const& columns, Received<Strike> const& received, double duration,
                       Sounds& sounds) {
    Strike const& call = received.call;
    Excited* const excitation = isSane(call) ? excited(call.object) : nullptr;
    if (excitation == nullptr) {
        return;
    }
    SoundingBody const& model = *excitation->model;
    Sounds::Body& body = *excitation->body;
    double const contact =
        call.contact > 0 ? call.contact : columns.contactTimeOf(call.object, call.other, call.impulse);
    body.local = model.sourceOf(call.point, call.normal);
    body.event = received.cause;
    Sounds::Impact impact;
    impact.object = call.object;
    impact.other = call.other;
    impact.at = inWorld(columns, call.object, call.point);
    impact.since = std::clamp(call.since, 0.0, duration);
    impact.first = static_cast<std::uint32_t>(sounds.amplitudes.size());
    impact.count = static_cast<std::uint32_t>(body.rings.size());
    double const rest = duration - impact.since;
    for (std::size_t i = 0; i < body.rings.size(); ++i) {
        Mode const& mode = model.modes()[i];
        double const amplitude = call.impulse * model.mobility(mode, call.point, call.normal) *
                                 spectrumOf(contact, mode.frequency) * mode.radiation;
        sounds.amplitudes.push_back(amplitude);
        double const meanSquare = amplitude * amplitude / 2;
        Decay const decay(2 * mode.decay, rest);
        double const heard = mode.audibility * meanSquare * rest * decay.mean;
        excitation->energy += heard;
        excitation->moment += heard * mode.frequency;
        left_[excitation->first + i] += meanSquare * decay.rest;
        impact.meanSquare += mode.audibility * meanSquare;
    }
    if (model.movedAir() > 0) {
        double const frequency = 1 / contact;
        impact.clickTime = contact;
        impact.clickPressure = clickPressure(model.movedAir(), model.mass(), call.impulse, contact);
        double const meanSquare = aWeighting(frequency) * impact.clickPressure * impact.clickPressure / 2;
        excitation->energy += meanSquare * contact;
        excitation->moment += meanSquare * contact * frequency;
        impact.meanSquare += meanSquare;
    }
    sounds.impacts.push_back(impact);
}

void SoundWork::rub(SoundColumns const& columns, Received<Rub> const& received, double duration,
                    Sounds& sounds) {
    Rub const& call = received.call;
    Excited* const excitation = isSane(call) ? excited(call.object) : nullptr;
    if (excitation == nullptr) {
        return;
    }
    SoundingBody const& model = *excitation->model;
    Sounds::Body& body = *excitation->body;
    body.local = model.sourceOf(call.point, call.normal);
    if (received.cause) {
        body.event = received.cause;
    }
    Sounds::Scrape scrape;
    scrape.object = call.object;
    scrape.other = call.other;
    scrape.at = inWorld(columns, call.object, call.point);
    scrape.first = static_cast<std::uint32_t>(sounds.amplitudes.size());
    scrape.count = static_cast<std::uint32_t>(body.rings.size());
    // The power spectrum of a noise of that force, white up to its bandwidth, in N²/Hz, two-sided.
    double const power = call.force * call.force / (2 * call.bandwidth);
    for (std::size_t i = 0; i < body.rings.size(); ++i) {
        Mode const& mode = model.modes()[i];
        double const relative = mode.frequency / call.bandwidth;
        double const amplitude = std::sqrt(power / (1 + relative * relative)) *
                                 model.mobility(mode, call.point, call.normal) * mode.radiation;
        sounds.amplitudes.push_back(amplitude);
        double const settled = amplitude * amplitude / (4 * mode.decay); // driven = damped
        Decay const decay(2 * mode.decay, duration);
        double const heard = mode.audibility * settled * duration * (1 - decay.mean);
        excitation->energy += heard;
        excitation->moment += heard * mode.frequency;
        left_[excitation->first + i] += settled * (1 - decay.rest);
    }
    sounds.scrapes.push_back(scrape);
}

void SoundWork::dieAway(double duration, Sounds& sounds) {
    auto next = excited_.cbegin();
    std::erase_if(sounds.bodies, [&](Sounds::Body& body) {
        Excited const* const excitation =
            next != excited_.cend() && next->object == body.object ? &*next++ : nullptr;
        double energy = excitation == nullptr ? 0 : excitation->energy;
        double moment = excitation == nullptr ? 0 : excitation->moment;
        bool audible = excitation != nullptr;
        for (std::size_t i = 0; i < body.rings.size(); ++i) {
            Sounds::Ring& ring = body.rings[i];
            if (ring.meanSquare > 0) {
                Decay const decay(2 * ring.decay, duration);
                double const heard = ring.weight * ring.meanSquare * duration * decay.mean;
                energy += heard;
                moment += heard * ring.frequency;
                ring.meanSquare *= decay.rest;
                if (ring.meanSquare < 1e-3 * inaudible) {
                    ring.meanSquare = 0;
                }
            }
            ring.meanSquare += excitation == nullptr ? 0 : left_[excitation->first + i];
            audible = audible || ring.meanSquare >= inaudible;
        }
        double weighted = body.brightness * body.loudness;
        smooth(weighted, moment / duration, duration);
        smooth(body.loudness, energy / duration, duration);
        body.brightness = body.loudness > 0 ? weighted / body.loudness : 0;
        return !audible && body.loudness < inaudible;
    });
}

void SoundWork::place(SoundColumns const& columns, Sounds& sounds) {
    for (Sounds::Body& body : sounds.bodies) {
        body.at = inWorld(columns, body.object, body.local);
        Velocity const* const velocity = columns.velocity.find(body.object);
        body.velocity = velocity == nullptr ? Vec2{} : velocity->value;
    }
}

} // namespace trembler
