#include "game/ui/edit/panels/command_palette.hpp"

#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/fields/drop_down.hpp"
#include "game/ui/edit/files/file_browser.hpp"
#include "game/ui/shared/commands/named_keys.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/cards.hpp"
#include "render/panels/theme.hpp"
#include "runtime/file/lower_case.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

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

std::vector<CommandPalette::Row> CommandPalette::rows(UiContext const& context, CommandSet const& commands,
                                                      std::span<PaletteEntry const> others) const {
    std::vector<Row> found;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        CommandInfo const& info = commands.info(i);
        std::string tip = shownTip(info, false, context.keys);
        if (commands.available(i) && !info.leads && fitsSearch(std::string(info.name) + " " + tip, typed_)) {
            auto const chords = context.keys.keysOf(info.id);
            found.push_back({i, std::string(info.name), chords.empty() ? "" : labelOf(chords.front()),
                             std::move(tip), "run " + std::string(info.id)});
        }
    }
    for (std::size_t i = 0; i < others.size(); ++i) {
        PaletteEntry const& other = others[i];
        if (fitsSearch(other.name + " " + other.id + " " + other.tip + " " + other.kindInWords, typed_)) {
            bool const part = other.kind == PaletteEntry::Kind::part;
            found.push_back({commands.size() + i, other.name, other.kindInWords, other.tip,
                             (part ? "found part " : "found joint ") + other.id});
        }
    }
    // What is called so comes before what is only described so.
    auto const rank = [typed = inLowerCase(typed_)](Row const& row) {
        std::string const name = inLowerCase(row.name);
        return name.starts_with(typed) ? 0 : fitsSearch(name, typed) ? 1 : 2;
    };
    std::stable_sort(found.begin(), found.end(),
                     [&](Row const& a, Row const& b) { return rank(a) < rank(b); });
    return found;
}

std::optional<std::size_t> CommandPalette::drawRows(UiContext& context, std::vector<Row> const& rows,
                                                    bool moved) {
    std::optional<std::size_t> run;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Row const& row = rows[i];
        ImGui::PushID(static_cast<int>(row.index));
        if (ImGui::Selectable(row.name.c_str(), i == chosen_)) {
            run = row.index;
        }
        context.layout.item(row.item);
        if (ImGui::IsItemHovered() && !row.tip.empty()) {
            tipBeside(row.tip);
        }
        if (i == chosen_ && moved) {
            ImGui::SetScrollHereY();
        }
        if (!row.right.empty()) {
            ImGui::SameLine(ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(row.right.c_str()).x);
            ImGui::TextDisabled("%s", row.right.c_str());
        }
        ImGui::PopID();
    }
    if (rows.empty()) {
        caption(words::nothingCalled);
    }
    return run;
}

std::optional<std::size_t> CommandPalette::draw(UiContext& context, CommandSet const& commands,
                                                std::span<PaletteEntry const> others) {
    MenuKeys const& keys = context.menuKeys;
    if (keys.pressed(MenuKey::back, true)) {
        close();
        return {};
    }
    context.letters.waitToBeAsked();
    std::vector<Row> const shown = rows(context, commands, others);
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
    if (textField("##typed", typed_, 80)) {
        chosen_ = 0;
    }
    context.layout.item("command name");
    float const room = std::min(ImGui::GetIO().DisplaySize.y / theme().scale - 190, 380.F);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, imColour4(palette::paper));
    ImGui::BeginChild("found", {0, scaled(room)});
    std::optional<std::size_t> run = drawRows(context, shown, down || up);
    ImGui::EndChild();
    ImGui::PopStyleColor();
    context.layout.endCard();
    if (keys.pressed(MenuKey::press) && !fresh_ && chosen_ < shown.size()) {
        run = shown[chosen_].index;
    }
    fresh_ = false;
    if (run) {
        close();
    }
    return run;
}

} // namespace trembler::ui
