// A small JSON Schema validator for the keywords that our schemas use: a reference that shares no code with
// the reader.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace trembler {

/// The errors in `value`, one line each; empty if it is valid. Throws std::invalid_argument for an
/// unsupported keyword, so that none is silently ignored.
[[nodiscard]] std::vector<std::string> validate(nlohmann::json const& schema, nlohmann::json const& value);

} // namespace trembler
