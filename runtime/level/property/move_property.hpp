// Turns, shifts and mirrors a property by its description alone: no property is named here.
#pragma once

#include "runtime/math/piece_frame.hpp"
#include "runtime/property/property_value.hpp"

namespace trembler {

/// Changes a value that is stated inside `outer` into the value in the frame that `outer` lies in, by the
/// geometric meaning of its fields (FieldGeometry). With `mirror`, the object is mirrored about its own y
/// axis before that. Fields without a geometric meaning stay as they are.
void moveProperty(PropertyValue& value, PieceFrame const& outer, bool mirror);

} // namespace trembler
