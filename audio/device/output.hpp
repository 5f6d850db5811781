// The output of rendered streams: loudspeakers, a buffer of a test, or none.
#pragma once

#include "audio/synth/room.hpp"
#include "audio/synth/synthesiser.hpp"

#include <string>

namespace trembler {

/// How streams are played.
struct OutputSettings {
    double volume = 0.8;  ///< 0 to 1
    double touches = 0.5; ///< 0 to 1, of the interface's sounds, in addition to `volume`
    bool hrtf = false;    ///< for headphones: directions by head-related transfer functions
    bool reverb = true;
    friend bool operator==(OutputSettings const&, OutputSettings const&) = default;
};

/// Used by one thread at a time.
class Output {
public:
    Output() = default;
    virtual ~Output() = default;
    Output(Output const&) = delete;
    Output& operator=(Output const&) = delete;

    /// Plays the next block of every stream. A stream that is missing has ended.
    virtual void play(std::span<Voice const> voices, Listener const& listener) = 0;
    /// Plays a sound (Pa at the listener) at once, beside the streams, and not ended by stop(). Does nothing
    /// where that is not possible.
    virtual void playOnce(std::span<float const> samples, double gain) {
        (void)samples;
        (void)gain;
    }
    virtual void set(OutputSettings const& settings) = 0;
    virtual void set(RoomAcoustics const& room) = 0;
    /// Stops all sound at once, for another world.
    virtual void stop() = 0;
    /// For display.
    [[nodiscard]] virtual std::string name() const = 0;
    /// Whether it can be heard.
    [[nodiscard]] virtual bool audible() const = 0;
};

/// Plays nothing.
class NullOutput final : public Output {
public:
    void play(std::span<Voice const>, Listener const&) override {}
    void set(OutputSettings const&) override {}
    void set(RoomAcoustics const&) override {}
    void stop() override {}
    [[nodiscard]] std::string name() const override { return "none"; }
    [[nodiscard]] bool audible() const override { return false; }
};

} // namespace trembler
