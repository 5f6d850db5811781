#include "audio/effect/sound_work.hpp"

#include "audio/effect/blow.hpp"
#include "audio/effect/recordings.hpp"
#include "audio/effect/smoothing.hpp"
#include "physics/depth.hpp"
#include "physics/dynamics/shape_rules.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

// The mean, over a stretch of `time` s, of what dies away like e^(-rate t), from 1.
double meanDecay(double rate, double time) {
    double const x = rate * time;
    return x > 1e-9 ? -std::expm1(-x) / x : 1;
}

bool isSane(Strike const& call) {
    return isFinite(call.point) && isFinite(call.normal) && std::isfinite(call.impulse) && call.impulse > 0 &&
           std::isfinite(call.contact) && call.contact > 0 && std::isfinite(call.since);
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

BodyFacts SoundColumns::factsOf(ObjectId id) const {
    BodyFacts facts;
    Shape const* const form = shape.find(id);
    Look const* const surface = look.find(id);
    facts.acoustics = acoustics.find(id);
    bool const isLiquid = liquid.has(id);
    if (form == nullptr || (surface == nullptr && facts.acoustics == nullptr && !isLiquid) ||
        faultIn(*form)) {
        return facts;
    }
    facts.shape = form;
    facts.fixed = fixed.has(id);
    if (isLiquid) {
        facts.material = Material::water; // whichever liquid it is, its bubbles are what is heard
    } else if (surface != nullptr) {
        facts.material = surface->material;
    }
    if (Mass const* const stated = mass.find(id)) {
        facts.mass = stated->value;
    } else {
        Density const* const dense = density.find(id);
        facts.mass = (dense == nullptr ? Density{} : *dense).value * areaOf(*form) * worldDepth;
    }
    return facts;
}

std::array<std::uint64_t, 8> SoundColumns::voiceVersions() const {
    return {shape.version(), look.version(),    acoustics.version(), sample.version(),
            mass.version(),  density.version(), fixed.version(),     liquid.version()};
}

void SoundCalls::clear() {
    strikes.clear();
    rubs.clear();
    plays.clear();
    holds.clear();
}

bool SoundWork::goesOn(Sounds const& sounds) {
    return !sounds.silent() || !sounds.blows.empty() || !sounds.scrapes.empty();
}

void SoundWork::advance(SoundColumns const& columns, SoundCalls const& calls, double duration,
                        Sounds& sounds) {
    if (columns.voiceVersions() != seen_) {
        models_.clear();
        seen_ = columns.voiceVersions();
    }
    fit(columns, sounds);
    sounds.blows.clear();
    sounds.scrapes.clear();
    sounds.amplitudes.clear();
    fresh_.clear();
    for (Told<Strike> const& told : calls.strikes) {
        strike(columns, told, duration, sounds);
    }
    for (Told<Rub> const& told : calls.rubs) {
        rub(columns, told, duration, sounds);
    }
    dieAway(duration, sounds);
    place(columns, sounds);
    advanceRecordings(columns, calls, duration, sounds);
}

SoundingBody const* SoundWork::modelOf(SoundColumns const& columns, ObjectId id) {
    auto at = models_.find(id);
    if (at == models_.end()) {
        BodyFacts const facts = columns.factsOf(id);
        if (facts.shape == nullptr) {
            return nullptr;
        }
        at = models_.emplace(id, SoundingBody(facts, modes_)).first;
    }
    return &at->second;
}

Sounds::Body& SoundWork::bodyOf(Sounds& sounds, SoundingBody const& model, ObjectId id) {
    auto const at =
        std::lower_bound(sounds.bodies.begin(), sounds.bodies.end(), id,
                         [](Sounds::Body const& body, ObjectId object) { return body.object < object; });
    if (at != sounds.bodies.end() && at->object == id) {
        return *at;
    }
    Sounds::Body fresh;
    fresh.object = id;
    for (Mode const& mode : model.modes()) {
        fresh.rings.push_back({mode.frequency, mode.decay, 0, aWeighting(mode.frequency)});
    }
    return *sounds.bodies.insert(at, std::move(fresh));
}

// Bodies that are gone fall silent. Those that ring with another number of modes than here, or have become
// something else, go on with the modes that they have now.
void SoundWork::fit(SoundColumns const& columns, Sounds& sounds) {
    std::erase_if(sounds.bodies,
                  [&](Sounds::Body const& body) { return modelOf(columns, body.object) == nullptr; });
    for (Sounds::Body& body : sounds.bodies) {
        std::vector<Mode> const& modes = modelOf(columns, body.object)->modes();
        body.rings.resize(modes.size());
        for (std::size_t i = 0; i < modes.size(); ++i) {
            Sounds::Ring& ring = body.rings[i];
            if (ring.frequency != modes[i].frequency || ring.decay != modes[i].decay) {
                ring = {modes[i].frequency, modes[i].decay, ring.meanSquare, aWeighting(modes[i].frequency)};
            }
        }
    }
}

void SoundWork::strike(SoundColumns const& columns, Told<Strike> const& told, double duration,
                       Sounds& sounds) {
    Strike const& call = told.call;
    SoundingBody const* const model = isSane(call) ? modelOf(columns, call.object) : nullptr;
    if (model == nullptr) {
        return;
    }
    Sounds::Body& body = bodyOf(sounds, *model, call.object);
    Fresh& fresh = fresh_[call.object];
    fresh.meanSquares.resize(body.rings.size());
    body.local = model->sourceOf(call.point, call.normal);
    body.event = told.cause;
    Sounds::Blow blow;
    blow.object = call.object;
    blow.other = call.other;
    blow.at = inWorld(columns, call.object, call.point);
    blow.since = std::clamp(call.since, 0.0, duration);
    blow.first = static_cast<std::uint32_t>(sounds.amplitudes.size());
    blow.count = static_cast<std::uint32_t>(body.rings.size());
    double const rest = duration - blow.since;
    for (std::size_t i = 0; i < body.rings.size(); ++i) {
        Mode const& mode = model->modes()[i];
        double const amplitude = call.impulse * model->mobility(mode, call.point, call.normal) *
                                 spectrumOf(call.contact, mode.frequency) * mode.radiation;
        sounds.amplitudes.push_back(amplitude);
        double const meanSquare = amplitude * amplitude / 2;
        double const heard = body.rings[i].weight * meanSquare * rest * meanDecay(2 * mode.decay, rest);
        fresh.energy += heard;
        fresh.moment += heard * mode.frequency;
        fresh.meanSquares[i] += meanSquare * std::exp(-2 * mode.decay * rest);
        blow.meanSquare += body.rings[i].weight * meanSquare;
    }
    if (model->movedAir() > 0) {
        double const frequency = 1 / call.contact;
        blow.clickTime = call.contact;
        blow.clickPressure = clickPressure(model->movedAir(), model->mass(), call.impulse, call.contact);
        double const meanSquare = aWeighting(frequency) * blow.clickPressure * blow.clickPressure / 2;
        fresh.energy += meanSquare * call.contact;
        fresh.moment += meanSquare * call.contact * frequency;
        blow.meanSquare += meanSquare;
    }
    sounds.blows.push_back(blow);
}

void SoundWork::rub(SoundColumns const& columns, Told<Rub> const& told, double duration, Sounds& sounds) {
    Rub const& call = told.call;
    SoundingBody const* const model = isSane(call) ? modelOf(columns, call.object) : nullptr;
    if (model == nullptr || model->modes().empty()) {
        return;
    }
    Sounds::Body& body = bodyOf(sounds, *model, call.object);
    Fresh& fresh = fresh_[call.object];
    fresh.meanSquares.resize(body.rings.size());
    body.local = model->sourceOf(call.point, call.normal);
    if (told.cause) {
        body.event = told.cause;
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
        Mode const& mode = model->modes()[i];
        double const relative = mode.frequency / call.bandwidth;
        double const amplitude = std::sqrt(power / (1 + relative * relative)) *
                                 model->mobility(mode, call.point, call.normal) * mode.radiation;
        sounds.amplitudes.push_back(amplitude);
        double const settled = amplitude * amplitude / (4 * mode.decay); // driven = damped
        double const heard =
            body.rings[i].weight * settled * duration * (1 - meanDecay(2 * mode.decay, duration));
        fresh.energy += heard;
        fresh.moment += heard * mode.frequency;
        fresh.meanSquares[i] += settled * -std::expm1(-2 * mode.decay * duration);
    }
    sounds.scrapes.push_back(scrape);
}

void SoundWork::dieAway(double duration, Sounds& sounds) {
    for (Sounds::Body& body : sounds.bodies) {
        auto const at = fresh_.find(body.object);
        double energy = at == fresh_.end() ? 0 : at->second.energy;
        double moment = at == fresh_.end() ? 0 : at->second.moment;
        for (std::size_t i = 0; i < body.rings.size(); ++i) {
            Sounds::Ring& ring = body.rings[i];
            if (ring.meanSquare > 0) {
                double const heard =
                    ring.weight * ring.meanSquare * duration * meanDecay(2 * ring.decay, duration);
                energy += heard;
                moment += heard * ring.frequency;
                ring.meanSquare *= std::exp(-2 * ring.decay * duration);
                if (ring.meanSquare < 1e-3 * inaudible) {
                    ring.meanSquare = 0;
                }
            }
            if (at != fresh_.end()) {
                ring.meanSquare += at->second.meanSquares[i];
            }
        }
        double weighted = body.brightness * body.loudness;
        smooth(weighted, moment / duration, duration);
        smooth(body.loudness, energy / duration, duration);
        body.brightness = body.loudness > 0 ? weighted / body.loudness : 0;
    }
    std::erase_if(sounds.bodies, [this](Sounds::Body const& body) {
        return body.loudness < inaudible && !fresh_.contains(body.object) &&
               std::all_of(body.rings.begin(), body.rings.end(),
                           [](Sounds::Ring const& ring) { return ring.meanSquare < inaudible; });
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
