// Mixes streams by OpenAL Soft: every stream has its place in space, and is queued block by block.
#pragma once

#include "audio/device/openal.hpp"
#include "audio/device/openal_device.hpp"
#include "audio/device/openal_reverb.hpp"
#include "audio/device/openal_streams.hpp"
#include "audio/device/output.hpp"
#include "audio/synth/limiter.hpp"

#include <memory>
#include <vector>

namespace trembler {

/// The world is the plane z = 0; the listener is in front of it. Pressures decrease with distance (inverse,
/// clamped at 1 m). Pitch is not changed: the streams already contain the Doppler effect, as shifting each
/// mode needs no resampling of a queue that must not run empty.
///
/// The mix, in stereo, is always rendered into memory, where a limiter keeps its true peak below full scale,
/// and then played by the sound device, if there is one: so loudspeakers and files get the same samples.
class OpenAlOutput final : public Output {
public:
    /// The default device of this machine, or nullptr, with the reason in `why`, if there is none.
    [[nodiscard]] static std::unique_ptr<OpenAlOutput> open(SynthesiserOptions const& format,
                                                            std::string& why);
    /// A device that plays into memory; see rendered(). Nullptr if OpenAL does not support this.
    [[nodiscard]] static std::unique_ptr<OpenAlOutput> loopback(SynthesiserOptions const& format,
                                                                std::string& why);
    ~OpenAlOutput() override;

    void play(std::span<Voice const> voices, Listener const& listener) override;
    void playOnce(std::span<float const> samples, double gain) override;
    void set(OutputSettings const& settings) override;
    void set(RoomAcoustics const& room) override;
    void stop() override;
    [[nodiscard]] std::string name() const override;
    [[nodiscard]] bool audible() const override { return speaker_ != nullptr; }

    /// The block of the last play(), left and right in turn, behind the limiter.
    [[nodiscard]] std::span<float const> rendered() const { return rendered_; }
    [[nodiscard]] bool hrtf() const;
    /// Blocks that came too late, or too early, for the device.
    [[nodiscard]] std::uint64_t slips() const {
        return leftOut_ + streams_.slips() + (speaker_ == nullptr ? 0 : speaker_->slips());
    }

    /// The greatest number of streams with separate places; fainter streams have no direction.
    static constexpr std::size_t mostPlaces = 64;
    /// Full scale of the mix, in Pa at the listener: 94 dB.
    static constexpr double fullScale = 1;
    /// Full scale of the sounds of the interface, in Pa: they stay below those of the world.
    static constexpr double interfaceFullScale = 2;

private:
    OpenAlOutput(ALCdevice* device, OpenAlExtensions const& extensions, SynthesiserOptions const& format);
    [[nodiscard]] bool start(std::string& why);
    void render();
    void playRest(std::span<Voice const* const> voices, Listener const& listener);

    ALCdevice* device_;
    ALCcontext* context_ = nullptr;
    SynthesiserOptions format_;
    OpenAlExtensions extensions_;
    OpenAlReverb reverb_;
    OpenAlStreams streams_;
    Limiter limiter_;
    std::unique_ptr<OpenAlDevice> speaker_; // nullptr: only into memory
    bool playing_ = false;                  // since the last stop()
    OutputSettings settings_;
    std::vector<float> rendered_;
    std::uint64_t leftOut_ = 0; // blocks that came too early
};

} // namespace trembler
