#include "game/ui/app/dropped_file.hpp"

#include "game/ui/shared/shown_faults.hpp"
#include "game/ui/shared/texts.hpp"
#include "runtime/level/json/json_document.hpp"

namespace trembler::ui {

DroppedFile lookAtDropped(std::filesystem::path const& file) {
    std::string const name = file.filename().string();
    try {
        auto const document = JsonDocument::load(file);
        nlohmann::json const& root = document->root();
        if (root.is_object() && root.contains("version")) {
            return {DroppedFile::Kind::level, {}};
        }
        if (root.is_object() &&
            (root.contains("placements") || root.contains("inputs") || root.contains("wires"))) {
            return {DroppedFile::Kind::solution, {}};
        }
    } catch (InputError const& error) {
        return {DroppedFile::Kind::neither,
                textWith("drop.unreadable", name, shownMessage(error.diagnostics().front()))};
    }
    return {DroppedFile::Kind::neither, textWith("drop.neither", name)};
}

} // namespace trembler::ui
