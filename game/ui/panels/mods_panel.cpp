#include "game/ui/panels/mods_panel.hpp"

#include "game/ui/panels/notation_card.hpp"
#include "game/ui/panels/time_bar.hpp"
#include "game/ui/shared/parameter_widgets.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/cards.hpp"
#include "render/panels/check_box.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <sstream>

namespace trembler::ui {
namespace {

using namespace render;

constexpr float modsWidth = 500;
constexpr float usageNumbers = 150; // width of the numbers behind a bar

void smallLines(std::string const& text) {
    smallCaption(text.c_str());
}

/// `framed`: in one line with a drop-down.
void heading(char const* text, bool framed = false) {
    ImGui::Dummy({0, scaled(2)});
    ImGui::PushFont(theme().fonts.strong);
    if (framed) {
        ImGui::AlignTextToFramePadding();
    }
    ImGui::TextUnformatted(text);
    ImGui::PopFont();
}

void warning(std::string const& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::warning));
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
}

/// In one word, and whether that is bad.
std::pair<std::string, bool> stateOf(ModScript const& script, ComponentStatus const& status) {
    if (!script.live->on()) {
        return {words::scriptOff, false};
    }
    if (script.failure) {
        return {words::scriptFailed, true};
    }
    switch (status.activity) {
    case Activity::active:
        return {words::active + std::string(", ") + words::duration(status.lastMicroseconds), false};
    case Activity::asleep:
        return {words::asleep, false};
    case Activity::absent:
        break;
    }
    return {words::absent, false};
}

void usageRow(char const* name, double share, std::string const& text) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::inkSoft));
    ImGui::TextUnformatted(name);
    ImGui::PopStyleColor();
    ImGui::TableNextColumn();
    drawTimeBar({.share = static_cast<float>(share), .text = text, .numbers = usageNumbers});
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("%s", words::instructionsTip);
    }
}

void drawUsage(ModScript const& script) {
    if (script.failure) {
        return; // it had turns, of which nothing is kept after the failure that stands above
    }
    heading(words::scriptUses);
    auto const usage = script.live->usage();
    if (!usage || usage->targets == 0) {
        smallLines(words::notApplied);
        return;
    }
    auto const share = [](auto used, auto most) {
        return most == 0 ? 0 : static_cast<double>(used) / static_cast<double>(most);
    };
    ImGui::PushFont(theme().fonts.small);
    if (ImGui::BeginTable("usage", 2, ImGuiTableFlags_SizingStretchProp)) {
        ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 0.24F);
        ImGui::TableSetupColumn("bar", ImGuiTableColumnFlags_WidthStretch, 0.76F);
        usageRow(words::instructions, share(usage->instructions, usage->mostInstructions),
                 words::ofMost(usage->instructions, usage->mostInstructions));
        usageRow(words::memory, share(usage->bytes, usage->mostBytes),
                 words::bytesOf(usage->bytes, usage->mostBytes));
        ImGui::EndTable();
    }
    ImGui::PopFont();
}

void drawTroubles(ModScript const& script) {
    if (!script.refused.empty()) {
        heading(words::fileRefused);
        ImGui::PushFont(theme().fonts.small);
        for (std::string const& problem : script.refused) {
            warning(problem);
        }
        ImGui::PopFont();
    }
    if (script.failure) {
        heading(words::failedInThisRun);
        ImGui::PushFont(theme().fonts.small);
        warning(words::inFrame(script.failure->frame, translated(script.failure->text)));
        if (!script.failure->traceback.empty()) {
            caption(words::howItCameThere);
            std::istringstream calls(script.failure->traceback);
            for (std::string call; std::getline(calls, call);) {
                ImGui::TextWrapped("%s", translated(call).c_str());
            }
        }
        ImGui::PopFont();
    }
}

void drawLog(Layout& layout, ModScript const& script) {
    constexpr std::size_t most = 6; // lines; the others are scrolled to
    if (script.log.empty()) {
        return;
    }
    heading(words::scriptLog);
    ImGui::PushFont(theme().fonts.small);
    float const lines = static_cast<float>(std::min(script.log.size(), most));
    ImGui::PushStyleColor(ImGuiCol_ChildBg, imColour4(palette::paperLight));
    ImGui::BeginChild("log", {0, lines * ImGui::GetTextLineHeightWithSpacing() + scaled(6)});
    bool const atEnd = ImGui::GetScrollY() >= ImGui::GetScrollMaxY();
    for (std::string const& line : script.log) {
        // The lines are the script's own, but for the note that there were more of them.
        bool const note = line.starts_with("... further lines of this frame");
        ImGui::TextWrapped("%s", note ? translated(line).c_str() : line.c_str());
    }
    if (atEnd) {
        ImGui::SetScrollHereY(1);
    }
    ImGui::EndChild();
    layout.item("log of " + script.live->name());
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

} // namespace

void ModsPanel::drawParameters(Layout& layout, LiveMods& liveMods, std::size_t number) {
    ModScript const& script = liveMods.scripts()[number];
    lua::Manifest const& manifest = script.live->script().manifest;
    std::string const& name = script.live->name();
    heading(words::parameters, manifest.attached);
    if (manifest.parameters.empty()) {
        smallLines(words::noParameters);
        return;
    }
    std::vector<ScriptUser> const users =
        manifest.attached ? liveMods.users(number) : std::vector<ScriptUser>();
    ScriptUser const* user = nullptr;
    if (!users.empty()) {
        auto const known = chosen_.find(name);
        auto const at = std::find_if(users.begin(), users.end(), [&](ScriptUser const& one) {
            return known != chosen_.end() && one.object == known->second;
        });
        bool const others = known != chosen_.end() && known->second == LastingObject{};
        user = others ? nullptr : (at == users.end() ? &users.front() : &*at);
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(words::forObject);
        ImGui::SameLine();
        ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
        if (ImGui::BeginCombo("##object", user == nullptr ? words::forOthers : user->name.c_str())) {
            for (std::size_t i = 0; i < users.size(); ++i) {
                ImGui::PushID(static_cast<int>(i));
                if (ImGui::Selectable(users[i].name.c_str(), user == &users[i])) {
                    chosen_[name] = users[i].object;
                }
                ImGui::PopID();
            }
            if (ImGui::Selectable(words::forOthers, user == nullptr)) {
                chosen_[name] = {};
            }
            ImGui::EndCombo();
        }
        layout.item("object of " + name);
    }
    // A saved file makes another version of the script: its manifest is then another one.
    std::optional<std::pair<std::string, lua::Value>> set;
    for (lua::Parameter const& parameter : manifest.parameters) {
        lua::Value const value = user != nullptr ? user->values.at(parameter.name) : parameter.initial;
        if (auto const changed = parameterWidget(layout, parameter, value, parameter.name + " of " + name)) {
            set.emplace(parameter.name, *changed);
        }
    }
    if (set && user != nullptr) {
        liveMods.setFor(number, user->object, set->first, set->second);
    } else if (set) {
        liveMods.setDefault(number, set->first, set->second);
    }
}

void ModsPanel::drawScript(Layout& layout, Registry const& registry, LiveMods& liveMods, std::size_t number,
                           ComponentStatus const& status) {
    ModScript const& script = liveMods.scripts()[number];
    std::string const& name = script.live->name();
    bool on = script.live->on();
    if (render::checkBox("##on", &on)) {
        liveMods.setOn(number, on);
    }
    layout.item("switch of " + name);
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("%s", words::scriptOn);
    }
    ImGui::SameLine();
    auto const [state, bad] = stateOf(script, status);
    bool const trouble = bad || !script.refused.empty();
    float const room = ImGui::CalcTextSize(state.c_str()).x + scaled(10);
    ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_AllowItemOverlap;
    if (liveMods.scripts().size() == 1 || trouble) {
        flags |= ImGuiTreeNodeFlags_DefaultOpen;
    }
    ImVec2 const at = ImGui::GetCursorScreenPos();
    float const width = ImGui::GetContentRegionAvail().x;
    ImGui::PushFont(theme().fonts.strong);
    bool const unfolded = ImGui::CollapsingHeader(name.c_str(), flags);
    ImGui::PopFont();
    layout.item("script " + name);
    ImVec2 const size = ImGui::CalcTextSize(state.c_str());
    float const middle = 0.5F * (ImGui::GetItemRectMin().y + ImGui::GetItemRectMax().y);
    ImGui::GetWindowDrawList()->AddText({at.x + width - room, middle - 0.5F * size.y},
                                        imColour(trouble ? palette::warning : palette::inkSoft),
                                        state.c_str());
    if (!unfolded) {
        return;
    }
    drawTroubles(script);
    drawNotationBox(boxOf(registry, script.live->info()));
    if (script.mod != nullptr) {
        smallLines(
            words::modLine(script.mod->name, script.mod->version, script.mod->author, script.mod->licence) +
            ". " +
            (script.mod->bundled ? std::string(words::bundledMod)
                                 : words::modFrom(script.mod->folder.parent_path().string())));
        smallLines(script.live->script().manifest.trust == lua::Trust::trusted ? words::trustedMod
                                                                               : words::untrustedMod);
    }
    drawParameters(layout, liveMods, number);
    if (liveMods.changed(number)) {
        if (ImGui::Button(words::asStated)) {
            liveMods.asStated(number);
        }
        layout.item("as stated, " + name);
    }
    drawUsage(script);
    drawLog(layout, script);
    ImGui::Dummy({0, scaled(6)});
}

void ModsPanel::draw(Layout& layout, Registry const& registry, LiveMods& liveMods, Session const& session,
                     float top, float height) {
    if (!open_) {
        return;
    }
    layout.beginCard("mods", words::mods,
                     {.anchor = Anchor::TopLeft, .offset = {16, top}, .width = modsWidth});
    if (session.altered()) {
        ImGui::PushFont(theme().fonts.small);
        warning(words::modsChanged);
        ImGui::PopFont();
    }
    float const used = ImGui::GetCursorPosY() + ImGui::GetStyle().WindowPadding.y;
    float const room = std::max(scaled(height) - used, scaled(120));
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
    ImGui::BeginChild("scripts", {0, content_ > 0 ? std::min(content_, room) : room});
    std::vector<ComponentStatus> const all = session.world().status();
    for (std::size_t i = 0; i < liveMods.scripts().size(); ++i) {
        ComponentInfo const* const info = &liveMods.scripts()[i].live->info();
        auto const status = std::find_if(all.begin(), all.end(),
                                         [&](ComponentStatus const& one) { return one.info == info; });
        ImGui::PushID(static_cast<int>(i));
        drawScript(layout, registry, liveMods, i, status == all.end() ? ComponentStatus{} : *status);
        ImGui::PopID();
    }
    content_ = ImGui::GetCursorPosY();
    ImGui::EndChild();
    ImGui::PopStyleColor();
    layout.endCard();
}

} // namespace trembler::ui
