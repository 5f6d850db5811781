#include "audio/synth/synthesiser.hpp"

#include "audio/effect/properties/decibel.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

constexpr double fading = 40; // 1/s, decay of the sound of destroyed objects
constexpr std::uint64_t recordingStream = std::uint64_t{1} << 63U; // above all objects
// A stream that becomes inaudible continues for a while, as ending and beginning again takes longer.
constexpr int patience = 6; // blocks

} // namespace

Synthesiser::Synthesiser(SynthesiserOptions options, SampleSource* recordings)
    : options_(options), recordings_(recordings), unheard_(static_cast<std::size_t>(options.block)) {}

void Synthesiser::clear() {
    bodies_.clear();
    recordingVoices_.clear();
    heardFrame_ = 0;
    blocks_ = 0;
}

double Synthesiser::pitchOf(Vec2 at, Vec2 velocity) const {
    if (!options_.doppler) {
        return 1;
    }
    // Only the part of the velocities along the line between source and listener counts.
    constexpr double fastest = 0.9 * speedOfSound;
    Vec2 const towards = listener_.at - at;
    double const distance = std::hypot(length(towards), listener_.height);
    double const approach = std::clamp(dot(velocity, towards) / distance, -fastest, fastest);
    double const flight = std::clamp(dot(listener_.velocity, towards) / distance, -fastest, fastest);
    return (speedOfSound - flight) / (speedOfSound - approach);
}

double Synthesiser::attenuationOf(Vec2 at) const {
    Vec2 const way = listener_.at - at;
    return 1 / std::max(1.0, lengthSquared(way) + listener_.height * listener_.height);
}

double Synthesiser::compressed(double meanSquare) const {
    double const above = meanSquare / meanSquareOf(options_.comfortable);
    return above > 1 ? std::pow(above, (options_.compression - 1) / 2) : 1;
}

void Synthesiser::hear(Sounds const& sounds, Listener const& listener) {
    listener_ = listener;
    hearBodies(sounds);
    hearRecordings(sounds);
    if (sounds.frame != heardFrame_) {
        heardFrame_ = sounds.frame;
        hearImpacts(sounds);
    }
}

void Synthesiser::hearBodies(Sounds const& sounds) {
    for (auto& [object, voice] : bodies_) {
        voice.gone = true;
    }
    for (Sounds::Body const& body : sounds.bodies) {
        auto const [at, isNew] = bodies_.try_emplace(body.object, options_.rate);
        BodyVoice& voice = at->second;
        voice.gone = false;
        voice.at = body.at;
        voice.velocity = body.velocity;
        voice.rings = body.rings;
    }
    for (auto& [object, voice] : bodies_) {
        voice.pitch = pitchOf(voice.at, voice.velocity);
        voice.attenuation = attenuationOf(voice.at);
        voice.bank.tune(voice.rings, voice.pitch, voice.gone ? fading : 0);
    }
}

void Synthesiser::hearImpacts(Sounds const& sounds) {
    std::span<double const> const amplitudes = sounds.amplitudes;
    for (Sounds::Impact const& impact : sounds.impacts) {
        auto const at = bodies_.find(impact.object);
        if (at == bodies_.end()) {
            continue;
        }
        BodyVoice& voice = at->second;
        double const scale = compressed(impact.meanSquare);
        int const sample = std::clamp(static_cast<int>(impact.since * options_.rate), 0, options_.block - 1);
        voice.bank.strike(amplitudes.subspan(impact.first, impact.count), scale, sample);
        int const length = static_cast<int>(std::lround(impact.clickTime * options_.rate / voice.pitch));
        if (impact.clickPressure > 0 && length >= 2) { // shorter clicks are inaudible
            voice.clicks.push_back({sample, length, scale * impact.clickPressure});
        }
    }
    for (Sounds::Scrape const& scrape : sounds.scrapes) {
        auto const at = bodies_.find(scrape.object);
        if (at == bodies_.end()) {
            continue;
        }
        std::span<double const> const rates = amplitudes.subspan(scrape.first, scrape.count);
        double settled = 0;
        for (std::size_t i = 0; i < std::min(rates.size(), at->second.rings.size()); ++i) {
            settled += rates[i] * rates[i] / (4 * at->second.rings[i].decay);
        }
        at->second.bank.scrape(rates, compressed(settled));
    }
}

void Synthesiser::hearRecordings(Sounds const& sounds) {
    for (auto& [serial, voice] : recordingVoices_) {
        voice.gone = true;
        voice.listed = false;
    }
    for (Sounds::Recording const& recording : sounds.recordings) {
        auto const [at, isNew] = recordingVoices_.try_emplace(recording.serial);
        RecordingVoice& voice = at->second;
        if (isNew && recordings_ != nullptr) {
            voice.player.emplace(recordings_->find(recording.file), recording.held);
        }
        voice.listed = true;
        voice.object = recording.object;
        voice.at = recording.at;
        voice.velocity = recording.velocity;
        voice.pitch = pitchOf(recording.at, recording.velocity);
        voice.pressure = std::sqrt(recording.meanSquare) * compressed(recording.meanSquare);
        voice.gone = !recording.held && recording.elapsed >= recording.duration;
    }
}

void Synthesiser::findAudible() {
    tones_.clear();
    for (auto& [object, voice] : bodies_) {
        voice.power = 0;
        for (Click const& click : voice.clicks) {
            voice.power += 0.5 * click.pressure * click.pressure * click.length / options_.block;
        }
        for (std::size_t i = 0; i < voice.bank.size(); ++i) {
            double const power = voice.bank.power(i);
            voice.power += power;
            tones_.push_back({voice.bank.bark(i), voice.attenuation * power, voice.bank.threshold(i)});
        }
    }
    if (options_.masking) {
        masker_.findAudible(tones_, audible_);
    } else {
        audible_.resize(tones_.size());
        std::transform(tones_.begin(), tones_.end(), audible_.begin(),
                       [](Tone const& tone) { return static_cast<std::uint8_t>(tone.power > 0); });
    }
    auto next = audible_.cbegin();
    for (auto& [object, voice] : bodies_) {
        auto const end = next + static_cast<std::ptrdiff_t>(voice.bank.size());
        voice.audible.assign(next, end);
        voice.anyAudible = !voice.clicks.empty() ||
                           std::any_of(next, end, [](std::uint8_t audible) { return audible != 0; });
        next = end;
    }
    counts_.bodies = bodies_.size();
    counts_.modes = static_cast<std::size_t>(
        std::count_if(tones_.begin(), tones_.end(), [](Tone const& tone) { return tone.power > 0; }));
    counts_.rendered = 0;
}

void Synthesiser::renderBody(ObjectId object, BodyVoice& voice, std::span<float> out) {
    std::uint64_t const seed = blocks_ * 0x100000001B3U + packed(object);
    counts_.rendered += voice.bank.render(out, voice.audible, seed, scratch_);
    for (Click& click : voice.clicks) {
        // One period of a sine, which may continue in the next block. Each sample is computed from the two
        // before.
        int const begin = std::max(0, click.sample);
        int const end = std::min(options_.block, click.sample + click.length);
        double const step = 2 * pi / click.length;
        double const twice = 2 * std::cos(step);
        double now = click.pressure * std::sin(step * (begin - click.sample));
        double last = click.pressure * std::sin(step * (begin - click.sample - 1));
        for (int n = begin; n < end; ++n) {
            out[static_cast<std::size_t>(n)] += static_cast<float>(now);
            double const next = twice * now - last;
            last = now;
            now = next;
        }
        click.sample -= options_.block;
    }
    std::erase_if(voice.clicks, [](Click const& click) { return click.sample + click.length <= 0; });
}

std::span<float> Synthesiser::newStream(std::uint64_t stream, ObjectId object, Vec2 at, Vec2 velocity,
                                        double power) {
    auto const block = static_cast<std::size_t>(options_.block);
    std::span<float> const samples = std::span(samples_).subspan(voices_.size() * block, block);
    voices_.push_back({stream, object, at, velocity, samples, power});
    return samples;
}

std::span<Voice const> Synthesiser::render() {
    ++blocks_;
    findAudible();
    std::erase_if(bodies_, [](auto const& entry) { return entry.second.gone && !(entry.second.power > 0); });
    std::erase_if(recordingVoices_, [](auto const& entry) {
        return !entry.second.listed && (!entry.second.player || entry.second.player->ended());
    });
    voices_.clear();
    samples_.assign((bodies_.size() + recordingVoices_.size()) * static_cast<std::size_t>(options_.block), 0);
    for (auto& [object, voice] : bodies_) {
        voice.unheard = voice.anyAudible ? 0 : voice.unheard + 1;
        if (voice.unheard > patience) {
            renderBody(object, voice, std::span(unheard_)); // continues, inaudible
            continue;
        }
        renderBody(object, voice, newStream(packed(object), object, voice.at, voice.velocity, voice.power));
    }
    for (auto& [serial, voice] : recordingVoices_) {
        std::span<float> const out = newStream(recordingStream + serial, voice.object, voice.at,
                                               voice.velocity, voice.pressure * voice.pressure);
        if (voice.player) {
            voice.player->render(out, options_.rate, voice.pressure, voice.pitch, voice.gone);
        }
    }
    return voices_;
}

} // namespace trembler
