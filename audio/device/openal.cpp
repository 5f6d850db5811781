#include "audio/device/openal.hpp"

#include <type_traits>

namespace trembler {
namespace {

template <class F>
void find(F& function, char const* name) {
    function = reinterpret_cast<F>(alGetProcAddress(name)); // NOLINT: how the library hands out functions
}

} // namespace

OpenAlExtensions OpenAlExtensions::withoutDevice() {
    OpenAlExtensions made;
    if (alcIsExtensionPresent(nullptr, "ALC_SOFT_loopback") == ALC_TRUE) {
        auto const get = [](auto& function, char const* name) {
            function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(
                alcGetProcAddress(nullptr, name)); // NOLINT
        };
        get(made.loopbackOpen, "alcLoopbackOpenDeviceSOFT");
        get(made.formatSupported, "alcIsRenderFormatSupportedSOFT");
        get(made.renderSamples, "alcRenderSamplesSOFT");
    }
    return made;
}

OpenAlEffects OpenAlEffects::of(ALCdevice* device) {
    OpenAlEffects made;
    if (alcIsExtensionPresent(device, "ALC_EXT_EFX") != ALC_TRUE) {
        return made;
    }
    find(made.genEffects, "alGenEffects");
    find(made.deleteEffects, "alDeleteEffects");
    find(made.effecti, "alEffecti");
    find(made.effectf, "alEffectf");
    find(made.genSlots, "alGenAuxiliaryEffectSlots");
    find(made.deleteSlots, "alDeleteAuxiliaryEffectSlots");
    find(made.sloti, "alAuxiliaryEffectSloti");
    find(made.slotf, "alAuxiliaryEffectSlotf");
    bool const complete = made.genEffects != nullptr && made.deleteEffects != nullptr &&
                          made.effecti != nullptr && made.effectf != nullptr && made.genSlots != nullptr &&
                          made.deleteSlots != nullptr && made.sloti != nullptr && made.slotf != nullptr;
    return complete ? made : OpenAlEffects{};
}

} // namespace trembler
