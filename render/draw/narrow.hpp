// Drawing uses floats.
#pragma once

namespace trembler::render {

/// Only for positions relative to the camera and for small lengths: a float keeps 7 digits.
[[nodiscard]] constexpr float narrow(double value) {
    return static_cast<float>(value);
}

} // namespace trembler::render
