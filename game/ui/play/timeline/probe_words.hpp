// The names of plotted numbers, for people.
#pragma once

#include <string>

namespace trembler::ui {

/// "coil.electrical_quantities.current" as "coil: Current"; others with the field as it is called. Window
/// thread only.
[[nodiscard]] std::string plotLabel(std::string const& what);

} // namespace trembler::ui
