// Commands on "texts": a level's texts in other languages.
#pragma once

#include "puzzle/edit/document/command.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace trembler::edit {

/// A text of the level beside its translation into another language.
struct TranslatedText {
    enum class Of { title, text, hint, goal } of = Of::title;
    std::size_t index = 0;   ///< of a hint
    std::string id;          ///< of a goal; empty: it has none, so its text cannot be translated
    std::string original;    ///< empty for a goal whose text is generated, or that does not exist
    std::string translation; ///< empty: there is none
    bool missing = false;    ///< the level says something here that the language lacks
    bool lost = false;       ///< a translation of a goal that does not exist
};

/// The languages that a level has texts in, in the order of the file.
[[nodiscard]] std::vector<std::string> languagesOf(Json const& level);
/// All texts that can be translated: title, text, hints, goals and task in the order of the file, then lost
/// ones. Of goals without an id only those with a text.
[[nodiscard]] std::vector<TranslatedText> translatedTexts(Json const& level, std::string const& language);

/// Adds a language: two small letters, as in "de". Throws CommandError for others, or one that is there.
[[nodiscard]] Command addLanguage(Json const& level, std::string const& language);
[[nodiscard]] Command removeLanguage(Json const& level, std::string const& language);
// These throw CommandError for a language that was not added. An empty text removes a translation.
[[nodiscard]] Command translateTitle(Json const& level, std::string const& language,
                                     std::string const& title);
[[nodiscard]] Command translateText(Json const& level, std::string const& language, std::string const& text);
/// A language has all hints or none, so the others are added as they are; hints that are all as in the level
/// are removed.
[[nodiscard]] Command translateHint(Json const& level, std::string const& language, std::size_t index,
                                    std::string const& hint);
[[nodiscard]] Command translateGoal(Json const& level, std::string const& language, std::string const& id,
                                    std::string const& text);

// Changes in all languages that follow from a change of the level's own texts; parts of other commands.

/// A hint of the level will be another one: where it keeps the place of a translation it is replaced.
void translationsChangedHint(Json& level, std::size_t index, Json const& before, std::string const& hint);
/// A hint was added at the end of the level's, was removed, or was moved.
void translationsGotHint(Json& level, std::string const& hint);
void translationsLostHint(Json& level, std::size_t index);
void translationsMovedHint(Json& level, std::size_t from, std::size_t to);
/// The id of a goal was changed.
void translationsRenamedGoal(Json& level, std::string const& from, std::string const& to);

} // namespace trembler::edit
