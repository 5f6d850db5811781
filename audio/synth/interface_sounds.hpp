// The short sounds of the program's own controls, made of struck modes like those of bodies.
#pragma once

#include <cstdint>
#include <vector>

namespace trembler {

enum class InterfaceSound : std::uint8_t {
    pickUp, ///< a part is taken
    place,  ///< it is put down
    refuse, ///< something was not done
    run,    ///< a run begins or ends
    solved, ///< the goals are reached
    click,  ///< a button is pressed that has no other sound
};

/// The whole sound at `rate` samples in a second, in Pa at the listener: soft, at most 1.2 s long, and equal
/// at every call.
[[nodiscard]] std::vector<float> samplesOf(InterfaceSound sound, int rate);

} // namespace trembler
