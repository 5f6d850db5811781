// The machine's sound device: plays a stereo mix, block by block.
#pragma once

#include "audio/device/openal.hpp"
#include "audio/device/openal_streams.hpp"
#include "audio/synth/synthesiser.hpp"

#include <memory>
#include <string>

namespace trembler {

/// Makes its own context of OpenAL current in every function. Used by one thread at a time.
class OpenAlDevice {
public:
    /// The default device, or nullptr, with the reason in `why`, if there is none.
    [[nodiscard]] static std::unique_ptr<OpenAlDevice> open(SynthesiserOptions const& format,
                                                            std::string& why);
    ~OpenAlDevice();
    OpenAlDevice(OpenAlDevice const&) = delete;
    OpenAlDevice& operator=(OpenAlDevice const&) = delete;

    /// Whether so many blocks are queued that the next block should be left out.
    [[nodiscard]] bool ahead();
    /// Queues a block, left and right in turn, as it is; 1 is full scale.
    void play(std::span<float const> samples);
    /// Plays a mono sound at once, beside the blocks.
    void playOnce(std::span<float const> samples, double gain);

    [[nodiscard]] std::string name() const;
    /// How often a block came too late.
    [[nodiscard]] std::uint64_t slips() const { return streams_.slips(); }

private:
    OpenAlDevice(ALCdevice* device, SynthesiserOptions const& format);
    [[nodiscard]] bool start(int rate, std::string& why);

    ALCdevice* device_;
    ALCcontext* context_ = nullptr;
    OpenAlStreams streams_;
};

} // namespace trembler
