// The JSON Schemas of the files that authors write.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <string_view>

namespace trembler {

enum class AuthoredFile { level, part, chapter };
/// The kinds, as `trembler schema` calls them, in the enumeration's order.
inline constexpr std::array<std::string_view, 3> authoredFiles{"level", "part", "chapter"};

/// The schema of a level file (levels/level.schema.json), of a part or of a chapter
/// (levels/chapter.schema.json). It covers the properties of every effect, and the property "scripts". The
/// names of scripts depend on the mods, so the schema allows any.
[[nodiscard]] nlohmann::ordered_json publishedSchema(AuthoredFile of = AuthoredFile::level);

} // namespace trembler
