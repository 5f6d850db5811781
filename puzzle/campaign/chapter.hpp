// A folder of levels as the player sees it: a chapter of puzzles, or a gallery of demonstrations.
#pragma once

#include "runtime/level/json/json_document.hpp"
#include "runtime/level/model/translation.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace trembler {

enum class ChapterKind : std::uint8_t {
    puzzles, ///< levels to be solved, in order
    gallery, ///< demonstrations: to be watched, taken apart and put together again, without a task to solve
};

struct Chapter {
    std::string title;
    std::string text;    ///< a sentence below the title; may be empty
    double order = 1000; ///< chapters are sorted by it, equal ones by the names of their folders
    ChapterKind kind = ChapterKind::puzzles;
    Translations texts{}; ///< in further languages
};

/// The file in a folder of levels that describes it.
inline constexpr std::string_view chapterFile = "chapter.json";

/// Whether a JSON file below a folder of levels is no level: a chapter's description, or a schema.
[[nodiscard]] bool isNotALevel(std::filesystem::path const& file);

/// "1-first-steps" becomes "First steps".
[[nodiscard]] std::string titleFromName(std::string const& name);

/// Throws InputError for anything that levels/chapter.schema.json does not allow.
[[nodiscard]] Chapter readChapter(std::shared_ptr<JsonDocument const> const& document);

/// The description of a folder: from its chapter.json; without one, the title is made from the folder's
/// name. Throws InputError if the file is wrong.
[[nodiscard]] Chapter loadChapter(std::filesystem::path const& folder);

/// levels/chapter.schema.json
[[nodiscard]] nlohmann::ordered_json chapterSchema();

} // namespace trembler
