#include "audio/device/openal_output.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace trembler {
namespace {

constexpr int longestQueue = 6;                         // blocks; beyond that the world runs too fast
constexpr std::uint64_t restStream = ~std::uint64_t{0}; // voices without a place of their own

void place(ALuint source, double x, double y, double z) {
    alSource3f(source, AL_POSITION, static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
}

} // namespace

OpenAlOutput::OpenAlOutput(ALCdevice* device, SynthesiserOptions const& format)
    : device_(device), format_(format), scaled_(static_cast<std::size_t>(format.block)) {}

std::unique_ptr<OpenAlOutput> OpenAlOutput::open(SynthesiserOptions const& format, std::string& why) {
    ALCdevice* const device = alcOpenDevice(nullptr);
    if (device == nullptr) {
        why = "this machine has no sound device";
        return nullptr;
    }
    std::unique_ptr<OpenAlOutput> made(new OpenAlOutput(device, format));
    return made->start({ALC_FREQUENCY, format.rate}, why) ? std::move(made) : nullptr;
}

std::unique_ptr<OpenAlOutput> OpenAlOutput::loopback(SynthesiserOptions const& format, std::string& why) {
    OpenAlExtensions const extensions = OpenAlExtensions::withoutDevice();
    ALCdevice* const device = extensions.canLoopBack() ? extensions.loopbackOpen(nullptr) : nullptr;
    if (device == nullptr) {
        why = "OpenAL cannot play into memory here";
        return nullptr;
    }
    std::unique_ptr<OpenAlOutput> made(new OpenAlOutput(device, format));
    made->extensions_ = extensions;
    made->cushion_ = 1;
    made->rendered_.resize(2 * static_cast<std::size_t>(format.block));
    if (extensions.formatSupported(device, format.rate, ALC_STEREO_SOFT, ALC_FLOAT_SOFT) != ALC_TRUE) {
        why = "OpenAL cannot play into memory in this format";
        return nullptr;
    }
    return made->start({ALC_FORMAT_CHANNELS_SOFT, ALC_STEREO_SOFT, ALC_FORMAT_TYPE_SOFT, ALC_FLOAT_SOFT,
                        ALC_FREQUENCY, format.rate},
                       why)
               ? std::move(made)
               : nullptr;
}

bool OpenAlOutput::start(std::vector<ALCint> attributes, std::string& why) {
    attributes.insert(attributes.end(), {ALC_HRTF_SOFT, ALC_FALSE, ALC_MONO_SOURCES, 2 * mostPlaces, 0});
    context_ = alcCreateContext(device_, attributes.data());
    if (context_ == nullptr || alcMakeContextCurrent(context_) != ALC_TRUE) {
        why = "OpenAL makes no context on this sound device";
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
    makeReverb();
    set(settings_);
    return true;
}

OpenAlOutput::~OpenAlOutput() {
    if (context_ != nullptr) {
        alcMakeContextCurrent(context_);
        stop();
        alDeleteSources(static_cast<ALsizei>(allSources_.size()), allSources_.data());
        alDeleteBuffers(static_cast<ALsizei>(allBuffers_.size()), allBuffers_.data());
        if (slot_ != 0) {
            effects_.deleteSlots(1, &slot_);
            effects_.deleteEffects(1, &effect_);
        }
        alcMakeContextCurrent(nullptr);
        alcDestroyContext(context_);
    }
    alcCloseDevice(device_);
}

std::string OpenAlOutput::name() const {
    if (extensions_) {
        return "memory";
    }
    char const* const name = alcGetString(device_, ALC_DEVICE_SPECIFIER);
    return name == nullptr ? "a sound device" : name;
}

bool OpenAlOutput::hrtf() const {
    ALCint on = ALC_FALSE;
    alcGetIntegerv(device_, ALC_HRTF_SOFT, 1, &on);
    return on == ALC_TRUE;
}

void OpenAlOutput::makeReverb() {
    effects_ = OpenAlEffects::of(device_);
    if (!effects_.loaded()) {
        return;
    }
    alGetError();
    effects_.genEffects(1, &effect_);
    effects_.genSlots(1, &slot_);
    if (alGetError() != AL_NO_ERROR) {
        effect_ = slot_ = 0;
        return;
    }
    effects_.effecti(effect_, AL_EFFECT_TYPE, AL_EFFECT_EAXREVERB);
    // Nothing of the direct sound: its distance must not change the echo, which fills the room evenly.
    effects_.effectf(effect_, AL_EAXREVERB_REFLECTIONS_GAIN, 0);
    effects_.effectf(effect_, AL_EAXREVERB_ROOM_ROLLOFF_FACTOR, 0);
    applyReverb();
}

void OpenAlOutput::applyReverb() {
    if (slot_ == 0) {
        return;
    }
    bool const on = settings_.reverb && room_.echo > 0;
    double const volume = std::clamp(room_.volume, 1.0, 1e5);
    effects_.effectf(effect_, AL_EAXREVERB_DECAY_TIME,
                     static_cast<float>(std::clamp(room_.reverberation, 0.1, 20.0)));
    // High notes die away sooner, as air and rough walls swallow them.
    effects_.effectf(effect_, AL_EAXREVERB_DECAY_HFRATIO, 0.6F);
    // The first echo comes after a mean free path, 4 V/S.
    double const delay = room_.surface > 0 ? 4 * volume / room_.surface / 343 : 0.01;
    effects_.effectf(effect_, AL_EAXREVERB_LATE_REVERB_DELAY,
                     static_cast<float>(std::clamp(delay, 0.0, 0.1)));
    // At full strength an echo is as loud as in OpenAL's generic room.
    constexpr double generic = 0.32;
    double const gain = on ? generic * std::sqrt(std::min(1.0, room_.echo)) : 0;
    effects_.effectf(effect_, AL_EAXREVERB_GAIN, static_cast<float>(gain));
    effects_.effectf(effect_, AL_EAXREVERB_LATE_REVERB_GAIN, 1);
    effects_.sloti(slot_, AL_EFFECTSLOT_EFFECT, static_cast<ALint>(effect_));
}

void OpenAlOutput::set(RoomAcoustics const& room) {
    if (!(room == room_)) {
        room_ = room;
        applyReverb();
    }
}

void OpenAlOutput::set(OutputSettings const& settings) {
    if (settings.hrtf != settings_.hrtf && alcIsExtensionPresent(device_, "ALC_SOFT_HRTF") == ALC_TRUE) {
        auto const reset = reinterpret_cast<LPALCRESETDEVICESOFT>(
            alcGetProcAddress(device_, "alcResetDeviceSOFT")); // NOLINT
        std::vector<ALCint> attributes{ALC_FREQUENCY, format_.rate, ALC_HRTF_SOFT,
                                       settings.hrtf ? ALC_TRUE : ALC_FALSE};
        if (extensions_) {
            attributes.insert(attributes.end(), {ALC_FORMAT_CHANNELS_SOFT, ALC_STEREO_SOFT,
                                                 ALC_FORMAT_TYPE_SOFT, ALC_FLOAT_SOFT});
        }
        attributes.push_back(0);
        if (reset != nullptr) {
            reset(device_, attributes.data());
        }
    }
    bool const reverb = settings.reverb != settings_.reverb;
    settings_ = settings;
    if (reverb) {
        applyReverb();
    }
    alListenerf(AL_GAIN, static_cast<float>(std::clamp(settings.volume, 0.0, 1.0)));
}

void OpenAlOutput::stop() {
    for (auto& [stream, source] : sources_) {
        alSourceRewind(source.id);
        alSourcei(source.id, AL_BUFFER, 0);
        idleSources_.push_back(source.id);
    }
    sources_.clear();
    idleBuffers_ = allBuffers_;
}

ALuint OpenAlOutput::freeBuffer() {
    if (idleBuffers_.empty()) {
        ALuint buffer = 0;
        alGenBuffers(1, &buffer);
        allBuffers_.push_back(buffer);
        return buffer;
    }
    ALuint const buffer = idleBuffers_.back();
    idleBuffers_.pop_back();
    return buffer;
}

OpenAlOutput::Source* OpenAlOutput::sourceFor(std::uint64_t stream) {
    auto const known = sources_.find(stream);
    if (known != sources_.end()) {
        return &known->second;
    }
    if (idleSources_.empty()) {
        ALuint id = 0;
        alGetError();
        alGenSources(1, &id);
        if (alGetError() != AL_NO_ERROR) {
            return nullptr;
        }
        allSources_.push_back(id);
        idleSources_.push_back(id);
    }
    Source source;
    source.id = idleSources_.back();
    idleSources_.pop_back();
    alSourcei(source.id, AL_SOURCE_RELATIVE, AL_FALSE);
    alSourcef(source.id, AL_REFERENCE_DISTANCE, 1);
    alSourcef(source.id, AL_ROLLOFF_FACTOR, 1);
    if (slot_ != 0) {
        alSource3i(source.id, AL_AUXILIARY_SEND_FILTER, static_cast<ALint>(slot_), 0, AL_FILTER_NULL);
    }
    return &sources_.emplace(stream, source).first->second;
}

void OpenAlOutput::reclaim(Source& source) {
    ALint done = 0;
    alGetSourcei(source.id, AL_BUFFERS_PROCESSED, &done);
    for (; done > 0; --done) {
        ALuint buffer = 0;
        alSourceUnqueueBuffers(source.id, 1, &buffer);
        idleBuffers_.push_back(buffer);
    }
}

// Whether so much is waiting to be played already that this block is better left out.
bool OpenAlOutput::ahead() {
    int longest = 0;
    for (auto& [stream, source] : sources_) {
        reclaim(source);
        ALint waiting = 0;
        alGetSourcei(source.id, AL_BUFFERS_QUEUED, &waiting);
        longest = std::max(longest, static_cast<int>(waiting));
    }
    return longest >= longestQueue;
}

void OpenAlOutput::queue(Source& source, std::span<float const> samples) {
    ALint state = 0;
    alGetSourcei(source.id, AL_SOURCE_STATE, &state);
    auto const add = [&](std::span<float const> block) {
        ALuint const buffer = freeBuffer();
        alBufferData(buffer, AL_FORMAT_MONO_FLOAT32, block.data(), static_cast<ALsizei>(block.size_bytes()),
                     format_.rate);
        alSourceQueueBuffers(source.id, 1, &buffer);
    };
    if (state != AL_PLAYING) { // it begins, or has run dry
        slips_ += state == AL_STOPPED ? 1 : 0;
        reclaim(source);
        std::vector<float> const silence(samples.size(), 0);
        for (int i = 0; i < cushion_; ++i) {
            add(silence);
        }
    }
    std::transform(samples.begin(), samples.end(), scaled_.begin(),
                   [](float s) { return s * static_cast<float>(1 / fullScale); });
    add(scaled_);
    if (state != AL_PLAYING) {
        alSourcePlay(source.id);
    }
    source.used = true;
}

// Voices too faint for places of their own, all in one, attenuated by hand.
void OpenAlOutput::playRest(std::span<Voice const* const> voices, Listener const& listener) {
    if (voices.empty() && !sources_.contains(restStream)) {
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
    if (Source* const source = sourceFor(restStream)) {
        alSourcei(source->id, AL_SOURCE_RELATIVE, AL_TRUE);
        place(source->id, 0, 0, -1);
        queue(*source, sum);
    }
}

// Streams that have ended play the rest of their queue, and then give their source back.
void OpenAlOutput::retire() {
    for (auto at = sources_.begin(); at != sources_.end();) {
        Source& source = at->second;
        ALint state = 0;
        alGetSourcei(source.id, AL_SOURCE_STATE, &state);
        if (!source.used && state != AL_PLAYING) {
            reclaim(source);
            alSourceRewind(source.id);
            alSourcei(source.id, AL_BUFFER, 0);
            idleSources_.push_back(source.id);
            at = sources_.erase(at);
        } else {
            source.used = false;
            ++at;
        }
    }
}

void OpenAlOutput::play(std::span<Voice const> voices, Listener const& listener) {
    alcMakeContextCurrent(context_);
    alListener3f(AL_POSITION, static_cast<float>(listener.at.x), static_cast<float>(listener.at.y),
                 static_cast<float>(listener.height));
    if (ahead()) {
        ++slips_;
        return;
    }
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
        return sources_.contains(voice->stream) ? clearly * power : power;
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](Voice const* a, Voice const* b) { return heard(a) > heard(b); });
    std::size_t const placed = std::min(order.size(), mostPlaces);
    for (std::size_t i = 0; i < placed; ++i) {
        if (Source* const source = sourceFor(order[i]->stream)) {
            place(source->id, order[i]->at.x, order[i]->at.y, 0);
            queue(*source, order[i]->samples);
        }
    }
    playRest(std::span(order).subspan(placed), listener);
    retire();
    if (extensions_) {
        extensions_->renderSamples(device_, rendered_.data(), format_.block);
    }
}

} // namespace trembler
