// Pieces of JSON Schema for the schemas of conditions.
#pragma once

#include "runtime/level/json/schema_pieces.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>

namespace trembler::goal_schema {

using json_schema::reference;
using json_schema::strictObject;

/// The name of an object, {"part": name}, or a list of these.
[[nodiscard]] nlohmann::ordered_json selector();
/// A condition of any kind.
[[nodiscard]] nlohmann::ordered_json condition();
/// A list of 1 to `most` items.
[[nodiscard]] nlohmann::ordered_json listOf(nlohmann::ordered_json items, std::size_t most);

} // namespace trembler::goal_schema
