#include "game/ui/edit/commands/edit_actions.hpp"
#include "game/ui/edit/fields/number_field.hpp"
#include "game/ui/edit/fields/page_elements.hpp"
#include "game/ui/edit/panels/side_panel.hpp"
#include "game/ui/edit/study/level_studies.hpp"
#include "game/ui/edit/study/study_rows.hpp"
#include "game/ui/edit/study/study_words.hpp"
#include "game/ui/shared/texts.hpp"
#include "render/panels/cards.hpp"
#include "render/panels/check_box.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::ui {
namespace {

using namespace render;

constexpr double mostRuns = 1e8; // as `trembler solve` takes them
constexpr double mostSeed = 1e9;

void drawRequest(EditParts& parts) {
    SearchRequest& request = parts.studies->request;
    float const column =
        ImGui::GetCursorPosX() + scaled(10) +
        std::max(ImGui::CalcTextSize(words::runsField).x, ImGui::CalcTextSize(words::seedField).x);
    auto const whole = [&](char const* name, char const* item, double& value, double low, double high) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(name);
        ImGui::SameLine(column);
        ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
        static_cast<void>(numberField(parts, item, value, low, high, "", true));
    };
    whole(words::runsField, "search runs", request.runs, 1, mostRuns);
    whole(words::seedField, "search seed", request.seed, 0, mostSeed);
    render::checkBox((std::string(words::handsField) + "##hands").c_str(), &request.hands);
    parts.context.layout.item("search hands");
}

void drawMoment(EditParts& parts, SearchShown const& shown, std::size_t index) {
    if (index >= shown.moments.size() || shown.moments[index] == nullptr) {
        return;
    }
    float const width = ImGui::GetContentRegionAvail().x;
    float const height = std::round(width * 9 / 16);
    // Only visible solutions get a picture.
    bool const seen = ImGui::IsRectVisible({width, height});
    Size const size{static_cast<int>(width), static_cast<int>(height)};
    unsigned const texture =
        seen ? parts.studies->pictures.texture(parts.context.canvas, index, *shown.moments[index], size) : 0;
    if (texture == 0) {
        ImGui::Dummy({width, height});
    } else {
        ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture)), {width, height},
                     {0, 1}, {1, 0});
    }
    parts.context.layout.item("found picture " + std::to_string(index));
}

void drawFound(EditParts& parts, SearchShown const& shown, std::size_t index) {
    insight::FoundSolution const& found = shown.search.found[index];
    std::string const item = "found " + std::to_string(index);
    ImGui::PushFont(theme().fonts.strong);
    ImGui::TextWrapped("%zu. %s", index + 1, words::shownMeans(parts.catalog(), found.graph).c_str());
    ImGui::PopFont();
    drawMoment(parts, shown, index);
    if (std::string const causes = words::shownCauses(found.graph); !causes.empty()) {
        studyText(words::filledIn(words::causesText, causes));
    }
    std::string const as = insight::recordedAs(shown.recorded, found);
    studyText((found.times == 1 ? words::filledIn(words::foundByOneText, found.run)
                                : words::filledIn(words::foundByText, found.run, found.times)) +
              "; " +
              (as.empty() ? std::string(words::recordedByNobody) : words::filledIn(words::likeText, as)));
    if (smallButton(parts, words::keepIt, item + " keep", words::keepItTip)) {
        actions::keepFound(parts, index);
    }
    besideIfRoom(words::playIt);
    if (smallButton(parts, words::playIt, item + " play", words::watchTip)) {
        actions::playRun(parts, insight::keptSolution(found, index + 1));
    }
    ImGui::Separator();
}

} // namespace

void drawSearchPage(EditParts& parts) {
    LevelStudies& studies = *parts.studies;
    Study<SearchShown> const& study = studies.searched();
    ImGui::BeginDisabled(study.running());
    drawRequest(parts);
    ImGui::EndDisabled();
    if (drawWorkButton(parts, study.work.get(), words::startSearch, words::startSearchTip, "search")) {
        actions::searchSolutions(parts);
    }
    auto const shown = study.result();
    if (shown == nullptr) {
        if (!study.running()) {
            caption(words::searchIntro);
        }
        return;
    }
    drawStateOfWork(study.state != actions::stateOf(parts, false), !study.running() && !shown->complete);
    studyText(words::filledIn(words::soFarText, shown->search.runs, studies.runsAsked(),
                              shown->search.found.size()));
    if (shown->search.solved < shown->search.runs) {
        studyText(
            words::filledIn(words::nearestText, localNumber(fmt::format("{:.3f}", shown->search.nearest))));
    }
    if (shown->search.found.empty() && !study.running()) {
        studyText(words::foundNothing);
    }
    for (std::size_t i = 0; i < shown->search.found.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        drawFound(parts, *shown, i);
        ImGui::PopID();
    }
}

} // namespace trembler::ui
