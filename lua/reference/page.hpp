// The reference as a page, as text and as JSON.
#pragma once

#include "lua/reference/reference.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace trembler::lua {

/// Markdown without a title.
[[nodiscard]] std::string referenceMarkdown(Reference const& reference);
/// Signatures and fields only, a line each.
[[nodiscard]] std::string referenceText(Reference const& reference);
/// {"globals": [...], "functions": [...], "properties": [...]}, examples included.
[[nodiscard]] nlohmann::ordered_json referenceJson(Reference const& reference);

} // namespace trembler::lua
