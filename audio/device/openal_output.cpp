#include "audio/device/openal_output.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace trembler {
namespace {

constexpr std::uint64_t restStream = ~std::uint64_t{0}; // voices without a separate place

} // namespace

OpenAlOutput::OpenAlOutput(ALCdevice* device, OpenAlExtensions const& extensions,
                           SynthesiserOptions const& format)
    : device_(device), format_(format), extensions_(extensions),
      streams_(format.block, format.rate, fullScale), limiter_({.rate = format.rate}),
      rendered_(2 * static_cast<std::size_t>(format.block)) {
    // Streams are queued directly before they are rendered; OpenAL needs some samples beyond the rendered
    // ones.
    constexpr int beyond = 64;
    streams_.setCushion(1, beyond);
}

std::unique_ptr<OpenAlOutput> OpenAlOutput::open(SynthesiserOptions const& format, std::string& why) {
    std::unique_ptr<OpenAlDevice> speaker = OpenAlDevice::open(format, why);
    if (speaker == nullptr) {
        return nullptr;
    }
    std::unique_ptr<OpenAlOutput> made = loopback(format, why);
    if (made != nullptr) {
        made->speaker_ = std::move(speaker);
    }
    return made;
}

std::unique_ptr<OpenAlOutput> OpenAlOutput::loopback(SynthesiserOptions const& format, std::string& why) {
    OpenAlExtensions const extensions = OpenAlExtensions::withoutDevice();
    ALCdevice* const device = extensions.canLoopBack() ? extensions.loopbackOpen(nullptr) : nullptr;
    if (device == nullptr) {
        why = "OpenAL cannot play into memory here";
        return nullptr;
    }
    std::unique_ptr<OpenAlOutput> made(new OpenAlOutput(device, extensions, format));
    if (extensions.formatSupported(device, format.rate, ALC_STEREO_SOFT, ALC_FLOAT_SOFT) != ALC_TRUE) {
        why = "OpenAL cannot play into memory in this format";
        return nullptr;
    }
    return made->start(why) ? std::move(made) : nullptr;
}

bool OpenAlOutput::start(std::string& why) {
    std::array<ALCint, 11> const attributes{ALC_FORMAT_CHANNELS_SOFT,
                                            ALC_STEREO_SOFT,
                                            ALC_FORMAT_TYPE_SOFT,
                                            ALC_FLOAT_SOFT,
                                            ALC_FREQUENCY,
                                            format_.rate,
                                            ALC_HRTF_SOFT,
                                            ALC_FALSE,
                                            ALC_MONO_SOURCES,
                                            2 * mostPlaces,
                                            0};
    context_ = alcCreateContext(device_, attributes.data());
    if (context_ == nullptr || alcMakeContextCurrent(context_) != ALC_TRUE) {
        why = "OpenAL makes no context in memory";
        return false;
    }
    if (alIsExtensionPresent("AL_EXT_float32") != AL_TRUE) {
        why = "this OpenAL takes no floating-point samples";
        return false;
    }
    alDistanceModel(AL_INVERSE_DISTANCE_CLAMPED);
    alDopplerFactor(0);
    std::array<float, 6> const orientation{0, 0, -1, 0, 1, 0};
    alListenerfv(AL_ORIENTATION, orientation.data());
    reverb_.make(device_);
    streams_.sendTo(reverb_.slot());
    streams_.prepare(mostPlaces + 1); // and the rest
    set(settings_);
    return true;
}

OpenAlOutput::~OpenAlOutput() {
    if (context_ != nullptr) {
        alcMakeContextCurrent(context_);
        streams_.destroy();
        reverb_.destroy();
        alcMakeContextCurrent(nullptr);
        alcDestroyContext(context_);
    }
    alcCloseDevice(device_);
}

std::string OpenAlOutput::name() const {
    return speaker_ == nullptr ? "memory" : speaker_->name();
}

bool OpenAlOutput::hrtf() const {
    ALCint on = ALC_FALSE;
    alcGetIntegerv(device_, ALC_HRTF_SOFT, 1, &on);
    return on == ALC_TRUE;
}

void OpenAlOutput::set(RoomAcoustics const& room) {
    alcMakeContextCurrent(context_);
    reverb_.set(room);
}

void OpenAlOutput::set(OutputSettings const& settings) {
    alcMakeContextCurrent(context_);
    if (settings.hrtf != settings_.hrtf && alcIsExtensionPresent(device_, "ALC_SOFT_HRTF") == ALC_TRUE) {
        auto const reset = reinterpret_cast<LPALCRESETDEVICESOFT>(
            alcGetProcAddress(device_, "alcResetDeviceSOFT")); // NOLINT
        std::array<ALCint, 9> const attributes{ALC_FREQUENCY,
                                               format_.rate,
                                               ALC_HRTF_SOFT,
                                               settings.hrtf ? ALC_TRUE : ALC_FALSE,
                                               ALC_FORMAT_CHANNELS_SOFT,
                                               ALC_STEREO_SOFT,
                                               ALC_FORMAT_TYPE_SOFT,
                                               ALC_FLOAT_SOFT,
                                               0};
        if (reset != nullptr) {
            reset(device_, attributes.data());
        }
    }
    settings_ = settings;
    reverb_.switchTo(settings.reverb);
    alListenerf(AL_GAIN, static_cast<float>(std::clamp(settings.volume, 0.0, 1.0)));
}

// The interface is heard at once, also between runs, when nothing is mixed: its sounds go to the device
// directly. They are 20 dB below full scale.
void OpenAlOutput::playOnce(std::span<float const> samples, double gain) {
    if (speaker_ != nullptr) {
        speaker_->playOnce(samples, gain * std::clamp(settings_.volume, 0.0, 1.0) / interfaceFullScale);
    } else {
        alcMakeContextCurrent(context_);
        streams_.once(samples, gain * fullScale / interfaceFullScale);
    }
}

void OpenAlOutput::render() {
    extensions_.renderSamples(device_, rendered_.data(), format_.block);
    limiter_.process(rendered_);
}

// What is being heard fades within the next block, as a sudden end would be heard as a click.
void OpenAlOutput::stop() {
    alcMakeContextCurrent(context_);
    streams_.stop();
    if (std::exchange(playing_, false)) {
        render();
        auto const last = static_cast<float>(rendered_.size());
        for (std::size_t n = 0; n < rendered_.size(); ++n) {
            rendered_[n] *= 1 - static_cast<float>(n) / last;
        }
        if (speaker_ != nullptr) {
            speaker_->play(rendered_);
        }
        alcMakeContextCurrent(context_);
        reverb_.clear();
        limiter_.clear();
    }
    std::fill(rendered_.begin(), rendered_.end(), 0.F);
}

// Plays the voices that are too faint for separate places as one stream, attenuated here.
void OpenAlOutput::playRest(std::span<Voice const* const> voices, Listener const& listener) {
    if (voices.empty() && !streams_.has(restStream)) {
        return;
    }
    std::vector<float> sum(static_cast<std::size_t>(format_.block), 0);
    for (Voice const* const voice : voices) {
        double const distance = std::hypot(length(voice->at - listener.at), listener.height);
        auto const gain = static_cast<float>(1 / std::max(1.0, distance));
        for (std::size_t n = 0; n < sum.size(); ++n) {
            sum[n] += gain * voice->samples[n];
        }
    }
    streams_.queue(restStream, {.z = -1, .relative = true}, sum);
}

void OpenAlOutput::play(std::span<Voice const> voices, Listener const& listener) {
    if (speaker_ != nullptr && speaker_->ahead()) {
        ++leftOut_;
        return;
    }
    alcMakeContextCurrent(context_);
    alListener3f(AL_POSITION, static_cast<float>(listener.at.x), static_cast<float>(listener.at.y),
                 static_cast<float>(listener.height));
    streams_.reclaim();
    playing_ = true;
    std::vector<Voice const*> order;
    for (Voice const& voice : voices) {
        order.push_back(&voice);
    }
    // A voice keeps its place until another is clearly louder, as a move would be heard.
    constexpr double clearly = 4; // 6 dB
    auto const heard = [&](Voice const* voice) {
        Vec2 const way = voice->at - listener.at;
        double const power =
            voice->power / std::max(1.0, lengthSquared(way) + listener.height * listener.height);
        return streams_.has(voice->stream) ? clearly * power : power;
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](Voice const* a, Voice const* b) { return heard(a) > heard(b); });
    std::size_t const placed = std::min(order.size(), mostPlaces);
    for (std::size_t i = 0; i < placed; ++i) {
        streams_.queue(order[i]->stream, {.x = order[i]->at.x, .y = order[i]->at.y}, order[i]->samples);
    }
    playRest(std::span(order).subspan(placed), listener);
    streams_.retire();
    render();
    if (speaker_ != nullptr) {
        speaker_->play(rendered_);
    }
}

} // namespace trembler
