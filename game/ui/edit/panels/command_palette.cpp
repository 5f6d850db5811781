#include "game/ui/edit/panels/command_palette.hpp"

#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/files/file_browser.hpp"
#include "game/ui/shared/commands/named_keys.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"
#include "runtime/file/lower_case.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

namespace trembler::ui {
namespace {

using namespace render;

} // namespace

bool fitsSearch(std::string const& text, std::string const& typed) {
    std::string const all = inLowerCase(text);
    std::istringstream words(inLowerCase(typed));
    for (std::string word; words >> word;) {
        if (all.find(word) == std::string::npos) {
            return false;
        }
    }
    return true;
}

void CommandPalette::begin() {
    open_ = true;
    fresh_ = true;
    typed_.clear();
    chosen_ = 0;
}

std::optional<std::size_t> CommandPalette::draw(UiContext& context, CommandSet const& commands) {
    MenuKeys const& keys = context.menuKeys;
    if (keys.pressed(MenuKey::back, true)) {
        close();
        return {};
    }
    context.letters.waitToBeAsked();
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        CommandInfo const& info = commands.info(i);
        if (commands.available(i) && !info.leads &&
            fitsSearch(std::string(info.name) + " " + shownTip(info, false, context.keys), typed_)) {
            shown.push_back(i);
        }
    }
    bool const down = keys.pressed(MenuKey::down, true);
    bool const up = keys.pressed(MenuKey::up, true);
    if (down) {
        ++chosen_;
    }
    if (up && chosen_ > 0) {
        --chosen_;
    }
    chosen_ = shown.empty() ? 0 : std::min(chosen_, shown.size() - 1);
    context.layout.beginCard("command palette", words::commandsTitle,
                             {.anchor = Anchor::Top, .offset = {0, 60}, .width = 460});
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (fresh_) {
        ImGui::SetKeyboardFocusHere();
    }
    bool const moved = down || up;
    if (textField("##typed", typed_, 80)) {
        chosen_ = 0;
    }
    context.layout.item("command name");
    std::optional<std::size_t> run;
    float const room = std::min(ImGui::GetIO().DisplaySize.y / theme().scale - 190, 380.F);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, imColour4(palette::paper));
    ImGui::BeginChild("found", {0, scaled(room)});
    for (std::size_t row = 0; row < shown.size(); ++row) {
        CommandInfo const& info = commands.info(shown[row]);
        auto const chords = context.keys.keysOf(info.id);
        ImGui::PushID(static_cast<int>(shown[row]));
        if (ImGui::Selectable(info.name, row == chosen_)) {
            run = shown[row];
        }
        context.layout.item("run " + std::string(info.id));
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", shownTip(info, false, context.keys).c_str());
        }
        if (row == chosen_ && moved) {
            ImGui::SetScrollHereY();
        }
        if (!chords.empty()) {
            std::string const key = labelOf(chords.front());
            ImGui::SameLine(ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(key.c_str()).x);
            ImGui::TextDisabled("%s", key.c_str());
        }
        ImGui::PopID();
    }
    ImGui::EndChild();
    ImGui::PopStyleColor();
    context.layout.endCard();
    if (keys.pressed(MenuKey::press) && !fresh_ && chosen_ < shown.size()) {
        run = shown[chosen_];
    }
    fresh_ = false;
    if (run) {
        close();
    }
    return run;
}

} // namespace trembler::ui
