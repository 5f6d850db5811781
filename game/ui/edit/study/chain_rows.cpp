#include "game/ui/edit/study/chain_rows.hpp"

#include "game/ui/edit/study/level_studies.hpp"
#include "game/ui/edit/study/study_rows.hpp"
#include "game/ui/edit/study/study_words.hpp"
#include "game/ui/shared/answer_language.hpp"
#include "game/ui/shared/texts.hpp"
#include "insight/why/words/words.hpp"
#include "render/panels/cards.hpp"

namespace trembler::ui {
namespace {

using namespace render;

/// The goal's sentence, as the player reads it.
std::string goalInWords(EditParts& parts, std::string const& id) {
    auto const& goals = parts.studies->report().of->goals;
    auto const at = goals.find(id);
    return at == goals.end() ? id : at->second;
}

} // namespace

void drawChains(EditParts& parts, insight::SolutionReport const& solution) {
    if (solution.chains.empty()) {
        return;
    }
    studyText(words::chainHeading);
    insight::AnswerLanguage const language = answerLanguageInUse();
    for (std::size_t i = 0; i < solution.chains.size(); ++i) {
        insight::Answer const& answer = solution.chains[i];
        std::string text;
        for (std::string const& sentence : sentencesOf(answer, goalInWords(parts, answer.goal), language)) {
            text += (text.empty() ? "" : " ") + sentence;
        }
        ImGui::BeginGroup();
        smallCaption(text.c_str());
        if (!answer.confirmed) {
            smallCaption(words::chainTraced);
        }
        ImGui::EndGroup();
        parts.context.layout.item("chain " + std::to_string(i));
    }
}

void drawComparisons(EditParts& parts, insight::LevelReport const& report) {
    for (std::size_t i = 0; i < report.comparisons.size(); ++i) {
        insight::KindComparison const& one = report.comparisons[i];
        ImGui::BeginGroup();
        studyText(words::filledIn(words::kindAgainstText, one.kind, one.with));
        for (auto const& [kind, side] :
             {std::pair(one.kind, &one.difference.here), {one.with, &one.difference.there}}) {
            if (std::string const only = words::shownSide(parts.catalog(), *side); !only.empty()) {
                smallCaption(words::filledIn(words::onlyKindText, kind, only).c_str());
            }
        }
        ImGui::EndGroup();
        parts.context.layout.item("kinds " + std::to_string(i));
    }
}

} // namespace trembler::ui
