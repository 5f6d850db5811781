// Converts old level files: each step turns one version of the format into the next.
#pragma once

#include <nlohmann/json.hpp>

#include <span>

namespace trembler {

struct LevelMigration {
    int from;                               ///< turns `from` into `from` + 1
    void (*step)(nlohmann::json& document); ///< must not change members that it does not know
};

/// All steps, ascending; the last one leads to levelVersion.
[[nodiscard]] std::span<LevelMigration const> levelMigrations();

/// Applies every step from the document's version on; `version` is the number that the file states.
void migrate(nlohmann::json& document, int version);

} // namespace trembler
