// What is drawn is drawn in floats.
#pragma once

namespace trembler::render {

/// Only for what is relative to the camera or small: a float keeps 7 digits.
[[nodiscard]] constexpr float narrow(double value) {
    return static_cast<float>(value);
}

} // namespace trembler::render
