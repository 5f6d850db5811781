#include "audio/device/openal_reverb.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {

void OpenAlReverb::make(ALCdevice* device) {
    effects_ = OpenAlEffects::of(device);
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
    // No early reflections: the distance of a source must not change the echo, which fills the room evenly.
    effects_.effectf(effect_, AL_EAXREVERB_REFLECTIONS_GAIN, 0);
    effects_.effectf(effect_, AL_EAXREVERB_ROOM_ROLLOFF_FACTOR, 0);
    apply();
}

void OpenAlReverb::apply() {
    if (slot_ == 0) {
        return;
    }
    bool const on = on_ && room_.echo > 0;
    double const volume = std::clamp(room_.volume, 1.0, 1e5);
    effects_.effectf(effect_, AL_EAXREVERB_DECAY_TIME,
                     static_cast<float>(std::clamp(room_.reverberation, 0.1, 20.0)));
    // High frequencies decay faster, as air and rough walls absorb them.
    effects_.effectf(effect_, AL_EAXREVERB_DECAY_HFRATIO, 0.6F);
    // The first echo arrives after a mean free path, 4 V/S.
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

void OpenAlReverb::destroy() {
    if (slot_ != 0) {
        effects_.deleteSlots(1, &slot_);
        effects_.deleteEffects(1, &effect_);
    }
}

void OpenAlReverb::set(RoomAcoustics const& room) {
    if (!(room == room_)) {
        room_ = room;
        apply();
    }
}

// OpenAL begins with a new, silent state when the kind of effect changes.
void OpenAlReverb::clear() {
    if (slot_ != 0) {
        effects_.sloti(slot_, AL_EFFECTSLOT_EFFECT, AL_EFFECT_NULL);
        apply();
    }
}

void OpenAlReverb::switchTo(bool on) {
    if (on != on_) {
        on_ = on;
        apply();
    }
}

} // namespace trembler
