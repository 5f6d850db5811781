// The echo of the room, computed by the effects extension of OpenAL.
#pragma once

#include "audio/device/openal.hpp"
#include "audio/device/output.hpp"

namespace trembler {

/// Without the extension it does nothing and slot() is 0. For every function the context must be current.
class OpenAlReverb {
public:
    /// To be called once, after the context was created.
    void make(ALCdevice* device);
    /// To be called before the context is destroyed.
    void destroy();

    void set(RoomAcoustics const& room);
    /// Switches the echo on or off.
    void switchTo(bool on);
    /// Ends the echo of all that was played so far.
    void clear();
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
