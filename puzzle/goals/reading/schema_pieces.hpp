// Pieces of JSON Schema that the kinds of conditions are described with.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace trembler::goal_schema {

/// {"$ref": ...} to a definition of the level's schema, for example "area".
[[nodiscard]] nlohmann::ordered_json reference(std::string_view name);
/// The name of an object, {"part": name}, or a list of these.
[[nodiscard]] nlohmann::ordered_json selector();
/// A condition of any kind.
[[nodiscard]] nlohmann::ordered_json condition();
/// An object with these members and no others.
[[nodiscard]] nlohmann::ordered_json strictObject(nlohmann::ordered_json properties,
                                                  std::vector<std::string> const& required);
/// A list of at least one.
[[nodiscard]] nlohmann::ordered_json listOf(nlohmann::ordered_json items, std::size_t most);

} // namespace trembler::goal_schema
