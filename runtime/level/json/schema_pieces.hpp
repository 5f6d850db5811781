// Pieces of JSON Schema that the schemas of levels, parts and goals are made from.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace trembler::json_schema {

/// {"$ref": ...} to a definition under "$defs".
[[nodiscard]] nlohmann::ordered_json reference(std::string_view definition);
/// A text for people or of a property, as JsonNode::text() reads it.
[[nodiscard]] nlohmann::ordered_json text();
/// A list of at most `most` items.
[[nodiscard]] nlohmann::ordered_json listOf(nlohmann::ordered_json items, std::size_t most);
/// An object with these members and no others.
[[nodiscard]] nlohmann::ordered_json strictObject(nlohmann::ordered_json properties,
                                                  std::vector<std::string> const& required = {});

} // namespace trembler::json_schema
