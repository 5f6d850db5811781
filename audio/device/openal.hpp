// The parts of OpenAL Soft that have to be looked up at run time.
#pragma once

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>
#include <AL/efx.h>

namespace trembler {

/// Extensions; a pointer is nullptr where the library lacks one.
struct OpenAlExtensions {
    LPALCLOOPBACKOPENDEVICESOFT loopbackOpen = nullptr;
    LPALCISRENDERFORMATSUPPORTEDSOFT formatSupported = nullptr;
    LPALCRENDERSAMPLESSOFT renderSamples = nullptr;

    /// The extensions that need no device.
    [[nodiscard]] static OpenAlExtensions withoutDevice();
    [[nodiscard]] bool canLoopBack() const {
        return loopbackOpen != nullptr && formatSupported != nullptr && renderSamples != nullptr;
    }
};

/// The effects extension of a context; loaded() is false if there is none.
struct OpenAlEffects {
    LPALGENEFFECTS genEffects = nullptr;
    LPALDELETEEFFECTS deleteEffects = nullptr;
    LPALEFFECTI effecti = nullptr;
    LPALEFFECTF effectf = nullptr;
    LPALGENAUXILIARYEFFECTSLOTS genSlots = nullptr;
    LPALDELETEAUXILIARYEFFECTSLOTS deleteSlots = nullptr;
    LPALAUXILIARYEFFECTSLOTI sloti = nullptr;
    LPALAUXILIARYEFFECTSLOTF slotf = nullptr;

    /// The extension of the current context.
    [[nodiscard]] static OpenAlEffects of(ALCdevice* device);
    [[nodiscard]] bool loaded() const { return genEffects != nullptr; }
};

} // namespace trembler
