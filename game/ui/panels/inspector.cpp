#include "game/ui/panels/inspector.hpp"

#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/theme.hpp"
#include "render/panels/unbroken.hpp"

#include <algorithm>

namespace trembler::ui {
namespace {

using namespace render;

void smallText(std::string const& text) {
    smallCaption(text.c_str());
}

void drawRow(InspectorRow const& row) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::inkSoft));
    ImGui::TextWrapped("%s", row.name.empty() ? row.meaning.c_str() : row.name.c_str());
    ImGui::PopStyleColor();
    if (ImGui::IsItemHovered() && !row.meaning.empty()) {
        ImGui::SetTooltip("%s", row.meaning.c_str());
    }
    ImGui::TableNextColumn();
    bool const apart = !row.unit.empty() && !row.unit.starts_with("°");
    ImGui::TextWrapped("%s", unbroken(row.value + (apart ? " " : "") + row.unit).c_str());
}

void drawSection(InspectorSection const& section, bool first) {
    if (!first) {
        ImGui::Dummy({0, scaled(2)});
        ImVec2 const at = ImGui::GetCursorScreenPos();
        ImGui::GetWindowDrawList()->AddLine(at, {at.x + ImGui::GetContentRegionAvail().x, at.y},
                                            imColour(palette::paperShade), scaled(1.2F));
        ImGui::Dummy({0, scaled(3)});
    }
    ImGui::PushFont(theme().fonts.strong);
    ImGui::TextUnformatted(section.title.c_str());
    ImGui::PopFont();
    if (!section.meaning.empty()) {
        smallText(section.meaning);
    }
    if (section.rows.empty()) {
        return;
    }
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(scaled(2), scaled(2)));
    if (ImGui::BeginTable(section.title.c_str(), 2, ImGuiTableFlags_SizingStretchProp)) {
        ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 0.44F);
        ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 0.56F);
        for (InspectorRow const& row : section.rows) {
            drawRow(row);
        }
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
}

/// As the goals have it at the ends of their lines.
bool whyButton(Layout& layout, char const* tip) {
    ImGui::PushFont(theme().fonts.small);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(scaled(9), scaled(2)));
    bool const asked = ImGui::Button(text("Why?"));
    ImGui::PopStyleVar();
    ImGui::PopFont();
    layout.item("why object");
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("%s", tip);
    }
    ImGui::Dummy({0, scaled(1)});
    return asked;
}

} // namespace

void Inspector::show(Session const& session, ObjectId object) {
    close();
    if (session.world().store().alive(object)) {
        subject_ = session.lasting(object);
        name_ = session.world().store().nameOf(object);
    }
}

ObjectId Inspector::object(Session const& session) const {
    return subject_ ? session.find(*subject_) : ObjectId{};
}

bool Inspector::draw(Layout& layout, Session const& session, SidePlace const& place, World const* past,
                     char const* whyTip) {
    shown_.clear();
    if (!open()) {
        return false;
    }
    ObjectId const subject = object(session);
    if (subject.valid()) {
        name_ = session.world().store().nameOf(subject); // placed otherwise, parts may have other names
    }
    shown_ = inspect(past != nullptr ? *past : session.world(), subject, scripts_);
    layout.beginCard(
        "inspector", "",
        {.anchor = Anchor::TopRight, .offset = {place.right, place.top}, .width = inspectorWidth});
    ImGui::PushFont(theme().fonts.heading);
    float const side = scaled(40);
    float const room = ImGui::GetContentRegionAvail().x - side;
    ImVec2 const start = ImGui::GetCursorPos();
    ImGui::PushTextWrapPos(start.x + room - scaled(8));
    ImGui::TextUnformatted(shownName(name_).c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    ImVec2 const after = ImGui::GetCursorPos();
    ImGui::SetCursorPos({start.x + room, start.y});
    bool const wanted = !iconButton("close", Icon::Cross, words::closeTip);
    layout.item("close inspector");
    ImGui::SetCursorPos({start.x, std::max(after.y, ImGui::GetCursorPos().y)});
    bool const asked = whyTip != nullptr && !shown_.empty() && whyButton(layout, whyTip);
    if (shown_.empty()) {
        caption(words::objectIsGone);
    } else {
        // The list scrolls in the remaining height.
        float const used = ImGui::GetCursorPosY() + ImGui::GetStyle().WindowPadding.y;
        ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
        ImGui::BeginChild("properties", {0, std::max(scaled(place.height) - used, scaled(80))});
        for (std::size_t i = 0; i < shown_.size(); ++i) {
            drawSection(shown_[i], i == 0);
        }
        ImGui::EndChild();
        ImGui::PopStyleColor();
    }
    layout.endCard();
    if (!wanted) {
        close();
    }
    return asked;
}

} // namespace trembler::ui
