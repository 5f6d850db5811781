#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/fields/field_widgets.hpp"
#include "game/ui/edit/fields/page_elements.hpp"
#include "game/ui/edit/panels/side_panel.hpp"
#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "puzzle/edit/commands/translations.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/cards.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>

namespace trembler::ui {
namespace {

using namespace render;
using edit::Json;
using edit::TranslatedText;

/// "de" and, if the program speaks it, "Deutsch".
std::string shownLanguage(std::string const& id) {
    for (Language const& language : languages()) {
        if (language.id == id) {
            return std::string(language.name) + " (" + id + ")";
        }
    }
    return id;
}

std::string headingOf(TranslatedText const& text) {
    using Of = TranslatedText::Of;
    switch (text.of) {
    case Of::title:
        return words::titleField;
    case Of::text:
        return words::storyField;
    case Of::hint:
        return textWith(words::hintField, text.index + 1);
    case Of::goal:
        break;
    }
    return text.id.empty() ? std::string(words::tabGoals) : textWith(words::goalWithId, text.id);
}

std::string itemOf(TranslatedText const& text) {
    using Of = TranslatedText::Of;
    switch (text.of) {
    case Of::title:
        return "translated title";
    case Of::text:
        return "translated text";
    case Of::hint:
        return "translated hint " + std::to_string(text.index);
    case Of::goal:
        break;
    }
    return "translated goal " + text.id;
}

edit::Command translate(Json const& level, std::string const& language, TranslatedText const& text,
                        std::string const& typed) {
    using Of = TranslatedText::Of;
    switch (text.of) {
    case Of::title:
        return edit::translateTitle(level, language, typed);
    case Of::text:
        return edit::translateText(level, language, typed);
    case Of::hint:
        return edit::translateHint(level, language, text.index, typed);
    case Of::goal:
        break;
    }
    return edit::translateGoal(level, language, text.id, typed);
}

/// A text as the level states it, the marker of a missing translation, and the field for the translation.
void drawTranslatedText(EditParts& parts, std::string const& language, TranslatedText const& text) {
    ImGui::Dummy({0, scaled(2)});
    ImGui::TextUnformatted(headingOf(text).c_str());
    if (text.missing) {
        ImGui::SameLine(0, scaled(8));
        ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::warning));
        ImGui::TextUnformatted(words::notTranslated);
        ImGui::PopStyleColor();
        parts.context.layout.item(itemOf(text) + " missing");
    }
    ImGui::PushFont(theme().fonts.small);
    if (text.lost || !text.original.empty()) {
        caption(text.lost ? words::lostGoal : text.original.c_str());
    } else if (text.of == TranslatedText::Of::goal) {
        caption(words::generatedGoal);
    }
    bool const withoutId = text.of == TranslatedText::Of::goal && text.id.empty();
    if (withoutId) {
        caption(words::goalWithoutId);
    }
    ImGui::PopFont();
    if (withoutId) {
        return;
    }
    std::string typed = text.translation;
    float const lines = text.of == TranslatedText::Of::title  ? 1
                        : text.of == TranslatedText::Of::text ? 4
                                                              : 2;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    // Each language has its own text in use.
    if (committedText(parts, itemOf(text) + " " + language, typed, lines)) {
        parts.run([&](Json const& level) { return translate(level, language, text, typed); });
    }
}

void drawLanguageChoice(EditParts& parts, std::vector<std::string> const& there) {
    if (!there.empty()) {
        std::string chosen = parts.translation;
        fieldName(words::languageField, "");
        if (choiceField(parts, "translation", chosen, there, shownLanguage)) {
            parts.translation = chosen;
        }
    }
    std::string added;
    // In a field for text this key cannot be another one.
    fieldName(words::addLanguageField, words::addLanguageTip(labelOf({SDLK_RETURN})));
    if (committedText(parts, "add language", added) && !added.empty() &&
        parts.run([&](Json const& level) { return edit::addLanguage(level, added); })) {
        parts.translation = added;
    }
}

} // namespace

void drawTranslations(EditParts& parts) {
    pageHeading(words::translationsHeading);
    std::vector<std::string> const there = edit::languagesOf(parts.tree());
    if (std::find(there.begin(), there.end(), parts.translation) == there.end()) {
        parts.translation = there.empty() ? std::string() : there.front();
    }
    drawLanguageChoice(parts, there);
    std::string const language = parts.translation;
    if (language.empty() || std::find(there.begin(), there.end(), language) == there.end()) {
        return; // one that was added in this picture is drawn in the next
    }
    std::vector<TranslatedText> const texts = edit::translatedTexts(parts.tree(), language);
    auto const missing =
        std::count_if(texts.begin(), texts.end(), [](TranslatedText const& text) { return text.missing; });
    caption(missing == 0 ? std::string(words::allTranslated).c_str()
                         : textWith(words::missingTexts, missing).c_str());
    for (TranslatedText const& text : texts) {
        drawTranslatedText(parts, language, text);
    }
    if (smallButton(parts, words::removeLanguage, "remove language")) {
        parts.run([&](Json const& level) { return edit::removeLanguage(level, language); });
    }
}

} // namespace trembler::ui
