#include "game/ui/edit/commands/edit_actions.hpp"
#include "game/ui/edit/fields/page_elements.hpp"
#include "game/ui/edit/panels/side_panel.hpp"
#include "game/ui/edit/study/chain_rows.hpp"
#include "game/ui/edit/study/level_studies.hpp"
#include "game/ui/edit/study/solution_rows.hpp"
#include "game/ui/edit/study/study_rows.hpp"
#include "game/ui/edit/study/study_words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/cards.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <map>

namespace trembler::ui {
namespace {

using namespace render;
using insight::LevelReport;

void drawShortcoming(words::ShownShortcoming const& one) {
    ImVec2 const at = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddCircleFilled({at.x + scaled(6), at.y + 0.5F * ImGui::GetTextLineHeight()}, scaled(4.5F),
                         imColour(palette::warning));
    ImGui::Indent(scaled(18));
    ImGui::TextWrapped("%s", one.what.c_str());
    smallCaption(one.help);
    ImGui::Unindent(scaled(18));
}

void drawShortcomings(EditParts& parts, LevelReport const& report) {
    pageHeading(words::fallsShort);
    if (report.demonstration) {
        return caption(words::isDemonstration);
    }
    auto const all = insight::shortcomingsOf(report);
    for (std::size_t i = 0; i < all.size(); ++i) {
        ImGui::BeginGroup();
        drawShortcoming(words::shownShortcoming(parts.catalog(), all[i]));
        ImGui::EndGroup();
        parts.context.layout.item("shortcoming " + std::to_string(i));
    }
    if (all.empty()) {
        ImGui::TextWrapped("%s", report.complete ? words::nothingShort : words::nothingShortYet);
    }
}

void drawDrops(EditParts& parts, LevelReport const& report) {
    if (report.drops.empty()) {
        return;
    }
    pageHeading(words::dropsHeading);
    for (insight::Drop const& drop : report.drops) {
        ImGui::BeginGroup();
        valueRow(parts.catalog().titleOf(drop.part),
                 drop.runs == 0 ? std::string(words::dropNowhere)
                                : words::filledIn(words::dropText, drop.solved, drop.runs));
        ImGui::EndGroup();
        parts.context.layout.item("drop " + drop.part);
    }
}

std::string shownMicroseconds(double time) {
    return words::filledIn(words::microsecondsText,
                           localNumber(fmt::format("{:.{}f}", time, time < 10 ? 1 : 0)));
}

/// By effect, the cheapest way that keeps every verdict, beside the present one.
void drawCheapest(insight::LevelCosts const& costs) {
    struct Ways {
        insight::WayToCompute const* present = nullptr;
        insight::WayToCompute const* cheapest = nullptr;
    };
    std::map<std::string, Ways> byEffect;
    for (insight::WayToCompute const& way : costs.ways) {
        // Detail levels of an effect and the steps of dynamics are different things.
        Ways& ways = byEffect[way.level.find("substep") == std::string::npos ? way.effect : "substeps"];
        if (way.present) {
            ways.present = &way;
        }
        if (way.keepsAll && (ways.cheapest == nullptr || way.microseconds < ways.cheapest->microseconds)) {
            ways.cheapest = &way;
        }
    }
    studyText(words::cheapestHeading);
    for (auto const& [effect, ways] : byEffect) {
        std::string shown = words::noneKeeps;
        if (ways.cheapest != nullptr) {
            std::string const best = translated(ways.cheapest->level);
            shown = ways.cheapest == ways.present ? words::filledIn(words::asNowText, best)
                    : ways.present != nullptr
                        ? words::filledIn(words::insteadText, best, translated(ways.present->level))
                        : best;
        }
        valueRow(translated(effect), shown);
    }
}

void drawCosts(EditParts& parts) {
    LevelStudies& studies = *parts.studies;
    pageHeading(words::costsHeading);
    if (drawWorkButton(parts, studies.costs().work.get(), words::measureCosts, words::measureCostsTip,
                       "measure costs")) {
        actions::measureCosts(parts);
    }
    auto const costs = studies.costs().result();
    if (costs == nullptr) {
        return;
    }
    drawStateOfWork(studies.costs().state != actions::stateOf(parts, true),
                    !studies.costs().running() && studies.costs().work->stopAsked());
    studyText(words::perFrame);
    for (insight::EffectCost const& cost : costs->costs) {
        valueRow(translated(cost.effect), shownMicroseconds(cost.microseconds));
    }
    drawCheapest(*costs);
}

void drawReport(EditParts& parts, LevelReport const& report) {
    if (report.examined) {
        drawShortcomings(parts, report);
        if (!report.emptyToolboxSolves) {
            studyText(words::notByItself);
        }
        studyText(words::filledIn(words::manyKindsText, report.kinds));
        drawComparisons(parts, report);
    }
    pageHeading(words::solutionsHeading);
    if (report.solutions.empty() && report.examined) {
        caption(words::reportNoSolutions);
    }
    for (std::size_t i = 0; i < report.solutions.size(); ++i) {
        drawReportedSolution(parts, report, i);
    }
    drawDrops(parts, report);
}

} // namespace

void drawReportPage(EditParts& parts) {
    LevelStudies& studies = *parts.studies;
    if (drawWorkButton(parts, studies.report().work.get(), words::makeReport, words::makeReportTip,
                       "make report")) {
        actions::makeReport(parts);
    }
    auto const report = studies.report().result();
    if (report == nullptr) {
        caption(words::reportIntro);
        return;
    }
    drawStateOfWork(studies.report().state != actions::stateOf(parts, true),
                    !studies.report().running() && !report->complete);
    drawReport(parts, *report);
    drawCosts(parts);
}

} // namespace trembler::ui
