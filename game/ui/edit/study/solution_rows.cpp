#include "game/ui/edit/study/solution_rows.hpp"

#include "game/ui/edit/commands/edit_actions.hpp"
#include "game/ui/edit/fields/page_elements.hpp"
#include "game/ui/edit/study/chain_rows.hpp"
#include "game/ui/edit/study/level_studies.hpp"
#include "game/ui/edit/study/study_rows.hpp"
#include "game/ui/edit/study/study_words.hpp"
#include "game/ui/shared/texts.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/cards.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::ui {
namespace {

using namespace render;
using insight::LevelReport;
using insight::PlaceMap;
using insight::SolutionReport;

/// "kind 1 · 3.2 s · 97 %"
std::string summaryOf(SolutionReport const& solution) {
    if (!solution.needs.solves) {
        return solution.expected ? words::solvesNot : words::solvesNotAsSaid;
    }
    std::string text =
        words::filledIn(words::kindText, solution.kind) + " · " +
        words::filledIn(words::secondsText,
                        localNumber(fmt::format("{:.1f}", static_cast<double>(solution.needs.frame) / 60)));
    if (solution.robustness.runs > 0) {
        text += " · " + words::filledIn(words::percentText, std::lround(100 * solution.robustness.share()));
    }
    return text;
}

std::size_t countOf(PlaceMap const& map, char state) {
    std::size_t count = 0;
    for (std::string const& row : map.rows) {
        count += static_cast<std::size_t>(std::count(row.begin(), row.end(), state));
    }
    return count;
}

void drawMaps(EditParts& parts, SolutionReport const& solution) {
    if (solution.maps.empty()) {
        return;
    }
    studyText(words::mayLie);
    LevelStudies& studies = *parts.studies;
    for (std::size_t i = 0; i < solution.maps.size(); ++i) {
        PlaceMap const& map = solution.maps[i];
        ImGui::PushID(static_cast<int>(i));
        ImVec2 const at = ImGui::GetCursorScreenPos();
        float const width = ImGui::GetContentRegionAvail().x;
        float const height = ImGui::GetTextLineHeight() + scaled(6);
        if (ImGui::Selectable("##places", studies.placement == i, 0, {width, height})) {
            studies.placement = i;
        }
        parts.context.layout.item("places " + std::to_string(i));
        std::size_t const solved = countOf(map, '#');
        std::string const places = words::filledIn(words::placesText, solved, solved + countOf(map, '.'));
        std::string const title = parts.catalog().titleOf(map.part);
        ImGui::PushFont(theme().fonts.small);
        ImDrawList& list = *ImGui::GetWindowDrawList();
        float const right = at.x + width - scaled(4) - ImGui::CalcTextSize(places.c_str()).x;
        ImVec4 const clip{at.x, at.y, right - scaled(6), at.y + height};
        list.AddText(nullptr, 0, {at.x + scaled(4), at.y + scaled(3)}, imColour(palette::ink), title.c_str(),
                     nullptr, 0, &clip);
        list.AddText({right, at.y + scaled(3)}, imColour(palette::inkSoft), places.c_str());
        ImGui::PopFont();
        ImGui::PopID();
    }
    double const step = solution.maps[std::min(studies.placement, solution.maps.size() - 1)].step;
    smallCaption(words::filledIn(words::mapCaption, std::lround(100 * step)).c_str());
}

void drawDetails(EditParts& parts, LevelReport const& report, SolutionReport const& solution) {
    PartCatalog const& catalog = parts.catalog();
    insight::Needs const& needs = solution.needs;
    if (needs.solves) {
        if (!solution.expected) {
            studyText(words::bySurprise);
        }
        std::vector<std::string> makings = needs.parts;
        makings.insert(makings.end(), needs.deeds.begin(), needs.deeds.end());
        studyText(makings.empty() ? std::string(words::needsNothing)
                                  : words::filledIn(words::needsText, words::shownMakings(catalog, makings)));
        if (!needs.superfluous.empty()) {
            studyText(
                words::filledIn(words::superfluousText, words::shownMakings(catalog, needs.superfluous)));
        }
        if (!needs.effects.empty()) {
            std::string effects;
            for (std::string const& effect : needs.effects) {
                effects += (effects.empty() ? "" : ", ") + translated(effect);
            }
            studyText(words::filledIn(words::needsEffectsText, effects));
        }
        if (std::string const causes = words::shownCauses(solution.graph); !causes.empty()) {
            studyText(words::filledIn(words::causesText, causes));
        }
        drawChains(parts, solution);
        if (solution.robustness.runs > 0) {
            studyText(words::shownRobustness(solution, report.jitter));
        } else if (report.complete) {
            studyText(words::nothingDisplaced);
        }
        drawMaps(parts, solution);
    }
    if (smallButton(parts, words::watchIt, "watch reported", words::watchTip)) {
        // As it was when the report was made, even if it was renamed or removed since.
        if (Solution const* const run = parts.studies->report().of->level.findSolution(solution.name)) {
            actions::playRun(parts, *run);
        }
    }
}

} // namespace

void drawReportedSolution(EditParts& parts, LevelReport const& report, std::size_t index) {
    LevelStudies& studies = *parts.studies;
    SolutionReport const& solution = report.solutions[index];
    bool const chosen = studies.solution == index;
    ImGui::PushID(static_cast<int>(index));
    ImVec2 const at = ImGui::GetCursorScreenPos();
    float const width = ImGui::GetContentRegionAvail().x;
    float const wrap = width - scaled(8);
    ImVec2 const name = ImGui::CalcTextSize(solution.name.c_str(), nullptr, false, wrap);
    float const line = theme().fonts.small->FontSize;
    if (ImGui::Selectable("##solution", chosen, 0, {width, name.y + line + scaled(8)})) {
        studies.solution = chosen ? LevelStudies::noChoice : index;
        studies.placement = 0;
    }
    parts.context.layout.item("reported " + std::to_string(index));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddText(nullptr, 0, {at.x + scaled(4), at.y + scaled(2)}, imColour(palette::ink),
                 solution.name.c_str(), nullptr, wrap);
    bool const wrong = solution.expected != solution.needs.solves;
    ImGui::PushFont(theme().fonts.small);
    list.AddText({at.x + scaled(4), at.y + name.y + scaled(4)},
                 imColour(wrong ? palette::warning : palette::inkSoft), summaryOf(solution).c_str());
    ImGui::PopFont();
    if (chosen) {
        ImGui::Indent(scaled(8));
        drawDetails(parts, report, solution);
        ImGui::Unindent(scaled(8));
    }
    ImGui::Separator();
    ImGui::PopID();
}

} // namespace trembler::ui
