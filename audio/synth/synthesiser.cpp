#include "audio/synth/synthesiser.hpp"

#include "audio/effect/decibel.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

constexpr double fading = 40;                                      // 1/s, by which what is gone dies away
constexpr std::uint64_t recordingStream = std::uint64_t{1} << 63U; // above all objects

double mean(std::span<float const> samples) {
    double sum = 0;
    for (float const sample : samples) {
        sum += static_cast<double>(sample) * static_cast<double>(sample);
    }
    return samples.empty() ? 0 : sum / static_cast<double>(samples.size());
}

} // namespace

Synthesiser::Synthesiser(SynthesiserOptions options, SampleSource* recordings)
    : options_(options), recordings_(recordings) {}

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
    // Only the part of a velocity along the line between the two counts.
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
        hearBlows(sounds);
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

void Synthesiser::hearBlows(Sounds const& sounds) {
    std::span<double const> const amplitudes = sounds.amplitudes;
    for (Sounds::Blow const& blow : sounds.blows) {
        auto const at = bodies_.find(blow.object);
        if (at == bodies_.end()) {
            continue;
        }
        BodyVoice& voice = at->second;
        double const scale = compressed(blow.meanSquare);
        int const sample = std::clamp(static_cast<int>(blow.since * options_.rate), 0, options_.block - 1);
        voice.bank.strike(amplitudes.subspan(blow.first, blow.count), scale, sample);
        int const length = static_cast<int>(std::lround(blow.clickTime * options_.rate / voice.pitch));
        if (blow.clickPressure > 0 && length >= 2) { // shorter ones are above hearing
            voice.clicks.push_back({sample, length, scale * blow.clickPressure});
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
    for (auto const& [object, voice] : bodies_) {
        for (std::size_t i = 0; i < voice.bank.size(); ++i) {
            tones_.push_back(
                {voice.bank.bark(i), voice.attenuation * voice.bank.power(i), voice.bank.threshold(i)});
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
        next = end;
    }
    counts_.bodies = bodies_.size();
    counts_.modes = static_cast<std::size_t>(
        std::count_if(tones_.begin(), tones_.end(), [](Tone const& tone) { return tone.power > 0; }));
    counts_.rendered = 0;
}

void Synthesiser::renderBody(ObjectId object, BodyVoice& voice, std::span<float> out) {
    std::uint64_t const seed = blocks_ * 0x100000001B3U + packed(object);
    counts_.rendered += voice.bank.render(out, voice.audible, seed);
    for (Click& click : voice.clicks) {
        // One period of a sine, which may go on into the next block.
        int const end = std::min(options_.block, click.sample + click.length);
        for (int n = std::max(0, click.sample); n < end; ++n) {
            double const phase = 2 * pi * (n - click.sample) / click.length;
            out[static_cast<std::size_t>(n)] += static_cast<float>(click.pressure * std::sin(phase));
        }
        click.sample -= options_.block;
    }
    std::erase_if(voice.clicks, [](Click const& click) { return click.sample + click.length <= 0; });
}

void Synthesiser::emit(std::uint64_t stream, ObjectId object, Vec2 at, Vec2 velocity, std::size_t first) {
    std::span<float const> const samples(samples_.data() + first, static_cast<std::size_t>(options_.block));
    voices_.push_back({stream, object, at, velocity, samples, mean(samples)});
}

std::span<Voice const> Synthesiser::render() {
    ++blocks_;
    std::erase_if(bodies_, [](auto const& entry) {
        BodyVoice const& voice = entry.second;
        bool silent = voice.gone && voice.clicks.empty();
        for (std::size_t i = 0; silent && i < voice.bank.size(); ++i) {
            silent = !(voice.bank.power(i) > 0);
        }
        return silent;
    });
    std::erase_if(recordingVoices_, [](auto const& entry) {
        return !entry.second.listed && (!entry.second.player || entry.second.player->ended());
    });
    findAudible();
    auto const block = static_cast<std::size_t>(options_.block);
    samples_.assign((bodies_.size() + recordingVoices_.size()) * block, 0);
    voices_.clear();
    std::size_t first = 0;
    for (auto& [object, voice] : bodies_) {
        renderBody(object, voice, std::span(samples_).subspan(first, block));
        emit(packed(object), object, voice.at, voice.velocity, first);
        first += block;
    }
    for (auto& [serial, voice] : recordingVoices_) {
        if (voice.player) {
            voice.player->render(std::span(samples_).subspan(first, block), options_.rate, voice.pressure,
                                 voice.pitch, voice.gone);
        }
        emit(recordingStream + serial, voice.object, voice.at, voice.velocity, first);
        first += block;
    }
    return voices_;
}

} // namespace trembler
