// "texts" of a level, a part or a chapter: its texts in further languages.
#pragma once

#include "runtime/level/json/json_node.hpp"
#include "runtime/level/model/translation.hpp"

namespace trembler {

enum class TextsOf { level, part };

/// Reads {"de": {"title", "text"}}; of a level also "hints" and "goals".
[[nodiscard]] Translations readTexts(JsonNode const& node, TextsOf of);
/// The inverse.
[[nodiscard]] nlohmann::ordered_json writeTexts(Translations const& texts);
/// The JSON Schema of it.
[[nodiscard]] nlohmann::ordered_json textsSchema(TextsOf of);

} // namespace trembler
