// Numbers as people read them, in the language in use.
#pragma once

#include <string>

namespace trembler::ui {

/// A number for people: about four digits; from 1e7 and below 1e-3 three digits with an exponent; "0" below
/// 1e-9.
[[nodiscard]] std::string readable(double value);

} // namespace trembler::ui
