// Pieces of JSON Schema that the kinds of conditions are described with.
#pragma once

#include "runtime/level/write/schema_pieces.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>

namespace trembler::goal_schema {

using json_schema::reference;
using json_schema::strictObject;

/// The name of an object, {"part": name}, or a list of these.
[[nodiscard]] nlohmann::ordered_json selector();
/// A condition of any kind.
[[nodiscard]] nlohmann::ordered_json condition();
/// A list of at least one item and at most so many.
[[nodiscard]] nlohmann::ordered_json listOf(nlohmann::ordered_json items, std::size_t most);

} // namespace trembler::goal_schema
