// Messages about wrong files and refused actions, in the player's language.
#pragma once

#include "runtime/level/json/diagnostic.hpp"

#include <exception>
#include <string>

namespace trembler::ui {

/// The message and the expected value, without the place.
[[nodiscard]] std::string shownMessage(Diagnostic const& fault);
/// With the place, as Diagnostic::print().
[[nodiscard]] std::string shownFault(Diagnostic const& fault);
/// A line for each problem of an InputError; of other errors the message.
[[nodiscard]] std::string shownError(std::exception const& error);

} // namespace trembler::ui
