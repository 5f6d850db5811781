#include "audio/device/openal_device.hpp"

#include <array>

namespace trembler {
namespace {

constexpr std::uint64_t mixStream = 0;
constexpr int mostWaiting = 6; // blocks; beyond that the world runs too fast

} // namespace

OpenAlDevice::OpenAlDevice(ALCdevice* device, SynthesiserOptions const& format)
    : device_(device), streams_(format.block, format.rate, 1, 2) {}

std::unique_ptr<OpenAlDevice> OpenAlDevice::open(SynthesiserOptions const& format, std::string& why) {
    ALCdevice* const device = alcOpenDevice(nullptr);
    if (device == nullptr) {
        why = "this machine has no sound device";
        return nullptr;
    }
    std::unique_ptr<OpenAlDevice> made(new OpenAlDevice(device, format));
    return made->start(format.rate, why) ? std::move(made) : nullptr;
}

// The mix contains the head-related transfer functions already, if they are wanted.
bool OpenAlDevice::start(int rate, std::string& why) {
    std::array<ALCint, 5> const attributes{ALC_FREQUENCY, rate, ALC_HRTF_SOFT, ALC_FALSE, 0};
    context_ = alcCreateContext(device_, attributes.data());
    if (context_ == nullptr || alcMakeContextCurrent(context_) != ALC_TRUE) {
        why = "OpenAL makes no context on this sound device";
        return false;
    }
    if (alIsExtensionPresent("AL_EXT_float32") != AL_TRUE) {
        why = "this OpenAL takes no floating-point samples";
        return false;
    }
    streams_.prepare(1);
    return true;
}

OpenAlDevice::~OpenAlDevice() {
    if (context_ != nullptr) {
        alcMakeContextCurrent(context_);
        streams_.destroy();
        alcMakeContextCurrent(nullptr);
        alcDestroyContext(context_);
    }
    alcCloseDevice(device_);
}

std::string OpenAlDevice::name() const {
    char const* const name = alcGetString(device_, ALC_DEVICE_SPECIFIER);
    return name == nullptr ? "a sound device" : name;
}

bool OpenAlDevice::ahead() {
    alcMakeContextCurrent(context_);
    streams_.reclaim();
    return streams_.longestQueue() >= mostWaiting;
}

void OpenAlDevice::play(std::span<float const> samples) {
    alcMakeContextCurrent(context_);
    streams_.queue(mixStream, {.relative = true}, samples);
}

void OpenAlDevice::playOnce(std::span<float const> samples, double gain) {
    alcMakeContextCurrent(context_);
    streams_.once(samples, gain);
}

} // namespace trembler
