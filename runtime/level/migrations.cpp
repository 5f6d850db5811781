#include "runtime/level/migrations.hpp"

#include <array>

namespace trembler {
namespace {

/// Version 0, the draft of the format, had the world's gravity at the top of the file and the toolbox as an
/// object {part: count}.
void fromDraft(nlohmann::json& document) {
    if (auto const gravity = document.find("gravity"); gravity != document.end()) {
        nlohmann::json value = *gravity;
        document.erase(gravity);
        nlohmann::json& world = document["world"];
        if (world.is_null()) {
            world = nlohmann::json::object();
        }
        if (world.is_object() && !world.contains("gravity")) {
            world["gravity"] = std::move(value);
        }
    }
    if (auto const toolbox = document.find("toolbox"); toolbox != document.end() && toolbox->is_object()) {
        nlohmann::json entries = nlohmann::json::array();
        for (auto const& [part, count] : toolbox->items()) {
            entries.push_back({{"part", part}, {"count", count}});
        }
        *toolbox = std::move(entries);
    }
}

constexpr std::array<LevelMigration, 1> steps{{{0, fromDraft}}};

} // namespace

std::span<LevelMigration const> levelMigrations() {
    return steps;
}

void migrate(nlohmann::json& document, int version) {
    for (LevelMigration const& migration : levelMigrations()) {
        if (migration.from >= version) {
            migration.step(document);
        }
    }
}

} // namespace trembler
