// The fields of a property, found by visiting a value of it.
#pragma once

#include "runtime/property/property_value.hpp"

#include <string>
#include <vector>

namespace trembler {

enum class FieldType { boolean, integer, number, vector, text, object, choice, list };

struct FieldOutline {
    FieldInfo info;
    FieldType type;
};

/// The top-level fields of a value, in order. They may depend on the value's choices.
[[nodiscard]] std::vector<FieldOutline> outlineOf(PropertyValue& value);

/// True for a property that files write bare: its one field has the key "value".
[[nodiscard]] bool isBare(std::vector<FieldOutline> const& fields);

/// True for a number, whole or not.
[[nodiscard]] bool isNumber(FieldOutline const& field);

/// True for a number that a running level's recording, panel and budget may change: it states an
/// AccuracyRange.
[[nodiscard]] bool isAccuracySetting(FieldOutline const& field);

/// True for a unit of angle or of angular speed: files state degrees.
[[nodiscard]] bool isAngle(std::string_view unit);
/// Convert between degrees in files and radians. Exact inverses for every angle that a file can state.
[[nodiscard]] double radians(double degrees);
[[nodiscard]] double degrees(double radians);

} // namespace trembler
