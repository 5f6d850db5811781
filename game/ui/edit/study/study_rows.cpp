#include "game/ui/edit/study/study_rows.hpp"

#include "game/ui/edit/fields/page_elements.hpp"
#include "game/ui/edit/study/study_words.hpp"
#include "game/ui/shared/shown_faults.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/cards.hpp"
#include "render/panels/theme.hpp"
#include "runtime/level/json/diagnostic.hpp"

#include <algorithm>

namespace trembler::ui {
namespace {

using namespace render;

void progressLine(AnyWork const& work) {
    insight::WorkDone const done = work.done();
    ImVec2 const at = ImGui::GetCursorScreenPos();
    float const width = ImGui::GetContentRegionAvail().x;
    float const height = scaled(6);
    float const share =
        done.of == 0 ? 0
                     : static_cast<float>(done.done) / static_cast<float>(std::max<std::size_t>(done.of, 1));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + width, at.y + height}, imColour(palette::paperShade), 0.5F * height);
    list.AddRectFilled(at, {at.x + std::clamp(share, 0.F, 1.F) * width, at.y + height},
                       imColour(palette::accent), 0.5F * height);
    ImGui::Dummy({width, height});
}

std::string whyFailed(std::exception_ptr const& failure) {
    try {
        std::rethrow_exception(failure);
    } catch (InputError const& error) {
        return error.diagnostics().empty() ? shownError(error) : shownFault(error.diagnostics().front());
    } catch (std::exception const& error) {
        return shownError(error);
    }
}

} // namespace

void studyText(std::string const& text) {
    ImGui::PushFont(theme().fonts.small);
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopFont();
}

void valueRow(std::string const& name, std::string const& value) {
    ImGui::PushFont(theme().fonts.small);
    float const width = ImGui::CalcTextSize(value.c_str()).x;
    float const room = ImGui::GetContentRegionAvail().x;
    float const left = ImGui::GetCursorPosX();
    bool const fits = ImGui::CalcTextSize(name.c_str()).x + width + scaled(10) <= room;
    ImGui::TextWrapped("%s", name.c_str());
    if (fits) {
        ImGui::SameLine();
    }
    ImGui::SetCursorPosX(left + std::max(0.F, room - width));
    ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::inkSoft));
    ImGui::TextUnformatted(value.c_str());
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

bool drawWorkButton(EditParts& parts, AnyWork const* work, char const* label, char const* tip,
                    std::string const& item) {
    bool const running = work != nullptr && work->running();
    bool const stopping = running && work->stopAsked();
    ImGui::BeginDisabled(stopping);
    bool const pressed = smallButton(parts,
                                     stopping  ? words::stopping
                                     : running ? words::stopStudy
                                               : label,
                                     item, running ? words::stopStudyTip : tip);
    ImGui::EndDisabled();
    if (running) {
        studyText(words::shownStep(work->step(), work->done()));
        progressLine(*work);
    } else if (std::exception_ptr const failure = work == nullptr ? nullptr : work->failure()) {
        caption(words::filledIn(words::cannotStudyText, whyFailed(failure)).c_str());
    }
    return pressed;
}

void drawStateOfWork(bool older, bool stopped) {
    if (!older && !stopped) {
        return;
    }
    ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::warning));
    if (older) {
        studyText(words::olderState);
    }
    if (stopped) {
        studyText(words::stoppedEarly);
    }
    ImGui::PopStyleColor();
}

} // namespace trembler::ui
