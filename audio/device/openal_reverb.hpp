// The echo of the room, by the effects extension of OpenAL.
#pragma once

#include "audio/device/openal.hpp"
#include "audio/device/output.hpp"

namespace trembler {

/// Without the extension it does nothing and slot() is 0. Every function needs its context to be current.
class OpenAlReverb {
public:
    /// Once, when the context has been made.
    void make(ALCdevice* device);
    /// Before the context goes.
    void destroy();

    void set(RoomAcoustics const& room);
    /// Whether the room is to be heard at all.
    void switchTo(bool on);
    /// The auxiliary slot that sources send to; 0 for none.
    [[nodiscard]] ALuint slot() const { return slot_; }

private:
    void apply();

    OpenAlEffects effects_;
    ALuint effect_ = 0;
    ALuint slot_ = 0;
    RoomAcoustics room_;
    bool on_ = OutputSettings{}.reverb;
};

} // namespace trembler
