// The fields of one value of a property, as the inspector shows them.
#pragma once

#include "puzzle/edit/inspect/inspector.hpp"

#include <optional>
#include <vector>

namespace trembler::edit {

/// The fields of a value in the form of files; of the initial value, if it is null. Nothing if it cannot be
/// read.
[[nodiscard]] std::optional<std::vector<InspectedField>>
fieldsOf(GameData const& data, Json const& level, PropertyInfo const& info, Json const& value);
/// Whether a property has no fields.
[[nodiscard]] bool isMarker(PropertyInfo const& info);

} // namespace trembler::edit
