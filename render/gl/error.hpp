// The only exception of the drawing layer: it states the failure in words that a player can act on.
#pragma once

#include <stdexcept>

namespace trembler::render {

/// Thrown by every constructor and function of render/ whose comment says that it can fail. what() is a full
/// sentence without a trailing newline; it names the cause and, where there is one, the remedy. Nothing in
/// render/ aborts instead.
class RenderError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

} // namespace trembler::render
