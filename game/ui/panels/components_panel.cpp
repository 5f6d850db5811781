#include "game/ui/panels/components_panel.hpp"

#include "game/ui/panels/attempt.hpp"
#include "game/ui/panels/time_bar.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/check_box.hpp"
#include "render/panels/theme.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler::ui {
namespace {

using namespace render;

constexpr float panelWidth = 620;

Colour colourOf(Activity activity) {
    switch (activity) {
    case Activity::active:
        return palette::goal;
    case Activity::asleep:
        return palette::accent;
    case Activity::absent:
        break;
    }
    return mix(palette::paperShade, palette::ink, 0.35F);
}

char const* wordFor(Activity activity) {
    switch (activity) {
    case Activity::active:
        return words::active;
    case Activity::asleep:
        return words::asleep;
    case Activity::absent:
        break;
    }
    return words::absent;
}

char const* headingFor(ComponentKind kind) {
    switch (kind) {
    case ComponentKind::resolver:
        return words::resolvers;
    case ComponentKind::dps:
        return words::derivedSets;
    case ComponentKind::interaction:
        break;
    }
    return words::interactions;
}

void drawState(Activity activity) {
    ImVec2 const at = ImGui::GetCursorScreenPos();
    float const height = ImGui::GetTextLineHeight();
    auto& list = *ImGui::GetWindowDrawList();
    ImVec2 const dot{at.x + scaled(6), at.y + 0.5F * height};
    // A ring for a sleeping component and a disc for an active one, so that colour is not the only
    // difference.
    if (activity == Activity::active) {
        list.AddCircleFilled(dot, scaled(4.5F), imColour(colourOf(activity)));
    } else {
        list.AddCircle(dot, scaled(4), imColour(colourOf(activity)), 0, scaled(1.6F));
    }
    ImGui::SetCursorScreenPos({at.x + scaled(17), at.y});
    ImGui::TextUnformatted(wordFor(activity));
}

} // namespace

void ComponentsPanel::drawRow(Layout& layout, ComponentStatus const& status, double slowest, Session& session,
                              Toasts& toasts) {
    std::string const name = title(*status.info);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    bool const absent = status.activity == Activity::absent;
    ImGui::PushStyleColor(ImGuiCol_Text, imColour4(absent ? palette::inkSoft : palette::ink));
    ImGui::AlignTextToFramePadding();
    ImGui::TextWrapped("%s", translated(name).c_str());
    ImGui::PopStyleColor();
    if (ImGui::IsItemHovered()) {
        ImGui::PushTextWrapPos(0);
        ImGui::SetTooltip("%s", words::wrapped(translated(std::string(status.info->text.work)), 60).c_str());
        ImGui::PopTextWrapPos();
    }
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    drawState(status.activity);
    ImGui::TableNextColumn();
    int period = status.period;
    ImGui::SetNextItemWidth(-1);
    ImGui::PushID(name.c_str());
    bool const mayChange = status.longestPeriod > 1;
    ImGui::BeginDisabled(!mayChange);
    if (ImGui::DragInt("##period", &period, 0.1F, 1, status.longestPeriod, "%d",
                       ImGuiSliderFlags_AlwaysClamp) &&
        period != status.period) {
        attempt(toasts, [&] { session.setPeriod(name, period); });
    }
    ImGui::EndDisabled();
    ImGui::PopID();
    if (ImGui::IsItemVisible()) { // skip rows that are scrolled out of sight
        layout.item("period of " + name);
    }
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
        ImGui::SetTooltip("%s", mayChange ? words::periodTip : words::periodFixedTip);
    }
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    if (!absent) {
        double const now = smooth_[name];
        float const share = slowest > 0 ? static_cast<float>(now / slowest) : 0.F;
        drawTimeBar(
            {.share = share > 0.005F ? share : 0.F, .text = fmt::format(numberLocale(), "{:.1Lf}", now)});
    }
}

void ComponentsPanel::drawTable(Layout& layout, Session& session, Toasts& toasts) {
    auto const all = session.world().status();
    double slowest = 0;
    for (ComponentStatus const& status : all) {
        double& smooth = smooth_[title(*status.info)];
        double const now = status.activity == Activity::active ? status.lastMicroseconds : 0;
        smooth += 0.12 * (now - smooth);
        slowest = std::max(slowest, smooth);
    }
    ImGui::PushFont(theme().fonts.small);
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(scaled(4), scaled(1)));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(scaled(4), scaled(2)));
    if (ImGui::BeginTable("components", 4, ImGuiTableFlags_SizingStretchProp)) {
        ImGui::TableSetupColumn(words::component, ImGuiTableColumnFlags_WidthStretch, 0.50F);
        ImGui::TableSetupColumn(words::state, ImGuiTableColumnFlags_WidthStretch, 0.17F);
        ImGui::TableSetupColumn(words::period, ImGuiTableColumnFlags_WidthStretch, 0.11F);
        ImGui::TableSetupColumn(words::timePerFrame, ImGuiTableColumnFlags_WidthStretch, 0.30F);
        ComponentStatus const* before = nullptr;
        for (ComponentStatus const& status : all) {
            if (!all_ && status.activity == Activity::absent) {
                continue;
            }
            if (before == nullptr || before->info->kind != status.info->kind) {
                ImGui::TableNextRow();
                ImGui::TableNextColumn();
                ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::accent));
                ImGui::PushFont(theme().fonts.strong);
                ImGui::TextUnformatted(headingFor(status.info->kind));
                ImGui::PopFont();
                ImGui::PopStyleColor();
                if (before == nullptr) {
                    for (char const* heading : {words::state, words::period, words::timePerFrame}) {
                        ImGui::TableNextColumn();
                        caption(heading);
                    }
                }
            }
            drawRow(layout, status, slowest, session, toasts);
            before = &status;
        }
        ImGui::EndTable();
    }
    ImGui::PopStyleVar(2);
    ImGui::PopFont();
}

void ComponentsPanel::draw(Layout& layout, Session& session, budget::BudgetMode& mode, Toasts& toasts,
                           float top, float height) {
    if (!open_) {
        return;
    }
    layout.beginCard("components", words::components,
                     {.anchor = Anchor::TopLeft, .offset = {16, top}, .width = panelWidth});
    costs_.drawBudget(layout, mode);
    float const used = ImGui::GetCursorPosY() + ImGui::GetStyle().WindowPadding.y;
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
    ImGui::BeginChild("table", {0, std::max(scaled(height) - used, scaled(120))});
    costs_.drawRows(layout, session, mode, toasts, all_);
    render::checkBox(words::showAbsent, &all_);
    layout.item("show absent components");
    drawTable(layout, session, toasts);
    ImGui::EndChild();
    ImGui::PopStyleColor();
    layout.endCard();
}

} // namespace trembler::ui
