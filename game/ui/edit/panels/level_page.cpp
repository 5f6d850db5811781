#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/fields/field_widgets.hpp"
#include "game/ui/edit/fields/page_elements.hpp"
#include "game/ui/edit/fields/part_choice.hpp"
#include "game/ui/edit/fields/property_rows.hpp"
#include "game/ui/edit/panels/side_panel.hpp"
#include "lua/mods/mod.hpp"
#include "puzzle/edit/commands/contents.hpp"
#include "puzzle/edit/commands/properties.hpp"
#include "render/panels/cards.hpp"
#include "render/panels/check_box.hpp"
#include "render/panels/theme.hpp"
#include "runtime/level/model/detail_levels.hpp"
#include "runtime/level/model/tool_count.hpp"

#include <algorithm>
#include <optional>

namespace trembler::ui {
namespace {

using namespace render;
using edit::Json;

std::string textAt(Json const& tree, char const* key) {
    return tree.is_object() && tree.contains(key) && tree[key].is_string() ? tree[key].get<std::string>()
                                                                           : std::string();
}

Json listAt(Json const& tree, char const* key) {
    return tree.is_object() && tree.contains(key) && tree[key].is_array() ? tree[key] : Json::array();
}

void drawTexts(EditParts& parts) {
    pageHeading(words::textsHeading);
    std::string title = textAt(parts.tree(), "title");
    fieldName(words::titleField, "");
    if (committedText(parts, "level title", title)) {
        parts.run([&](Json const& level) { return edit::setTitle(level, title); });
    }
    std::string text = textAt(parts.tree(), "text");
    ImGui::TextUnformatted(words::storyField);
    if (committedText(parts, "level text", text, 4)) {
        parts.run([&](Json const& level) { return edit::setText(level, text); });
    }
    bool demonstration = parts.level.demonstration;
    if (render::checkBox(words::demonstrationField, &demonstration)) {
        parts.run([&](Json const& level) { return edit::setDemonstration(level, demonstration); });
    }
    parts.context.layout.item("demonstration");
    pageHeading(words::hintsHeading);
    Json const hints = listAt(parts.tree(), "hints");
    for (std::size_t i = 0; i < hints.size(); ++i) {
        std::string const item = "hint " + std::to_string(i);
        std::string hint = hints[i].is_string() ? hints[i].get<std::string>() : "";
        if (committedText(parts, item, hint, 2)) {
            parts.run([&](Json const& level) { return edit::setHint(level, i, hint); });
        }
        ImGui::PushID(item.c_str());
        if (smallButton(parts, words::removeIt, item + " remove")) {
            parts.run([&](Json const& level) { return edit::removeHint(level, i); });
        }
        if (auto const to = orderArrows(parts, item, i, hints.size())) {
            parts.run([&](Json const& level) { return edit::moveHint(level, i, *to); });
        }
        ImGui::PopID();
    }
    if (smallButton(parts, words::addHint, "add hint")) {
        parts.run([&](Json const& level) { return edit::addHint(level, words::newHint); });
    }
}

/// Of the number of wires, with an entry for it and without: a drag from 0 makes the entry and continues.
constexpr char const* wiresId = "wires";

bool isUnlimited(Json const& tool, char const* key) {
    return tool.contains(key) && tool[key] == unlimitedWord;
}

/// A count from `least`, with a button that makes it unlimited, or a number again; `beside` is the width of
/// the buttons that follow in pixels. Returns the new count.
std::optional<int> countField(EditParts& parts, std::string const& item, double count, double least,
                              bool unlimited, float beside) {
    float const gap = scaled(3);
    float const sign = ImGui::CalcTextSize("∞").x + 2 * ImGui::GetStyle().FramePadding.x;
    float const width = ImGui::GetContentRegionAvail().x - beside - sign - gap;
    std::optional<int> wanted;
    if (unlimited) {
        ImGui::AlignTextToFramePadding();
        ImVec2 const at = ImGui::GetCursorPos();
        ImGui::TextUnformatted(words::anyNumber);
        ImGui::SetCursorPos({at.x + width, at.y});
        ImGui::Dummy({0, ImGui::GetFrameHeight()});
    } else {
        ImGui::SetNextItemWidth(width);
        if (numberField(parts, item, count, least, 1000, "", true)) {
            wanted = static_cast<int>(count);
        }
    }
    ImGui::SameLine(0, gap);
    if (smallButton(parts, "∞", item + " unlimited", unlimited ? words::limitedTip : words::unlimitedTip)) {
        // A change of its own: it does not go on with that of the field that was used before.
        parts.widget = {parts.document.newGesture(), edit::Gesture::Next::replaces};
        wanted = unlimited ? 1 : unlimitedCount;
    }
    return wanted;
}

/// How many wires the player may lay; `beside` is the width of the buttons that follow in pixels.
void drawWires(EditParts& parts, double count, bool unlimited, float beside) {
    fieldName(words::wiresField, words::wiresTip);
    if (auto const wanted = countField(parts, "wires", count, 0, unlimited, beside)) {
        runWidget(
            parts, [&](Json const& level) { return edit::setWires(level, *wanted); }, true);
    }
}

double numberAt(Json const& tool, char const* key, double otherwise) {
    return tool.contains(key) && tool[key].is_number() ? tool[key].get<double>() : otherwise;
}

/// The number of a part, or of the wires; `beside` is the width of the buttons that follow in pixels.
void drawCount(EditParts& parts, Json const& tool, std::size_t index, float beside) {
    if (tool.contains("wire")) {
        return drawWires(parts, numberAt(tool, "wire", 0), isUnlimited(tool, "wire"), beside);
    }
    std::string const item = "tool " + std::to_string(index);
    if (auto const wanted =
            countField(parts, item, numberAt(tool, "count", 1), 1, isUnlimited(tool, "count"), beside)) {
        runWidget(
            parts, [&](Json const& level) { return edit::setToolCount(level, index, *wanted); }, true);
    }
}

void drawTool(EditParts& parts, Json const& tool, std::size_t index, std::size_t count) {
    bool const ofWires = tool.contains("wire");
    std::string const item = "tool " + std::to_string(index);
    float const gap = scaled(3);
    float const remove =
        gap + ImGui::CalcTextSize(words::removeShort).x + 2 * ImGui::GetStyle().FramePadding.x;
    auto const drawWidgets = [&] {
        drawCount(parts, tool, index, orderArrowsWidth() + remove);
        if (auto const to = orderArrows(parts, item, index, count)) {
            parts.run([&](Json const& level) { return edit::moveTool(level, index, *to); });
        }
        ImGui::SameLine(0, gap);
        if (smallButton(parts, words::removeShort, item + " remove", words::removeIt)) {
            parts.run([&](Json const& level) {
                return ofWires ? edit::setWires(level, 0) : edit::removeTool(level, index);
            });
        }
    };
    std::string const part = textAt(tool, "part");
    // By its name, so that the ring of the keyboard stays with an entry that is moved.
    ImGui::PushID(ofWires ? wiresId : part.c_str());
    if (ofWires) {
        drawWidgets();
    } else {
        partRow(parts, part, drawWidgets);
    }
    ImGui::PopID();
}

void drawToolboxRows(EditParts& parts) {
    pageHeading(words::toolboxHeading);
    Json const tools = listAt(parts.tree(), "toolbox");
    bool wires = false;
    for (std::size_t i = 0; i < tools.size(); ++i) {
        wires = wires || (tools[i].is_object() && tools[i].contains("wire"));
        drawTool(parts, tools[i].is_object() ? tools[i] : Json::object(), i, tools.size());
    }
    if (!wires) {
        ImGui::PushID(wiresId);
        drawWires(parts, 0, false, 0);
        ImGui::PopID();
    }
    std::string chosen;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (partChoice(parts, "add tool", chosen, parts.data->parts.names(), words::addTool)) {
        parts.run([&](Json const& level) { return edit::addTool(level, chosen, 1); });
    }
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("%s", words::addToolTip);
    }
}

void drawWorld(EditParts& parts) {
    pageHeading(words::worldHeading);
    if (parts.level.bounds) {
        Box bounds = *parts.level.bounds;
        bool changed = false;
        fieldName(words::boundsField, words::boundsTip);
        float const half = 0.5F * (ImGui::GetContentRegionAvail().x - scaled(4));
        auto const number = [&](char const* item, double& value, double low, bool second) {
            if (second) {
                ImGui::SameLine(0, scaled(4));
            }
            ImGui::SetNextItemWidth(half);
            changed = numberField(parts, item, value, low, 1e6, "m") || changed;
        };
        number("bounds x", bounds.corner.x, -1e6, false);
        number("bounds y", bounds.corner.y, -1e6, true);
        fieldName("", "");
        number("bounds width", bounds.size.x, 0.01, false);
        number("bounds height", bounds.size.y, 0.01, true);
        if (changed) {
            runWidget(
                parts, [&](Json const& level) { return edit::setBounds(level, bounds); }, true);
        }
        if (smallButton(parts, words::noBounds, "no bounds")) {
            parts.run([&](Json const& level) { return edit::setBounds(level, {}); });
        }
    } else if (smallButton(parts, words::giveBounds, "give bounds")) {
        parts.run([&](Json const& level) { return edit::setBounds(level, Box{{-4, -0.5}, {8, 4}}); });
    }
    if (parts.level.placing && smallButton(parts, words::anywhere, "place anywhere", words::anywhereTip)) {
        parts.run([](Json const& level) { return edit::placeAnywhere(level); });
    }
    for (edit::InspectedProperty const& property : edit::inspectWorld(*parts.data, parts.tree())) {
        drawWorldProperty(parts, property);
    }
    pageHeading(words::detailHeading);
    for (auto const& [effect, levels] : detailLevels(parts.data->registry)) {
        auto const stated = parts.level.detail.find(effect);
        std::string chosen = stated == parts.level.detail.end() ? std::string() : stated->second;
        std::vector<std::string> choices{""};
        choices.insert(choices.end(), levels.begin(), levels.end());
        fieldName(shownField(effect), words::detailTip);
        if (choiceField(parts, "detail " + effect, chosen, choices, shownChoice)) {
            parts.run([&, name = effect](Json const& level) {
                return edit::setDetail(*parts.data, level, name, chosen);
            });
        }
    }
}

void drawMods(EditParts& parts) {
    pageHeading(words::modsHeading);
    std::vector<std::string> mods; // as the file has them: one that is not loaded yet is not read
    for (Json const& name : listAt(parts.tree(), "mods")) {
        if (name.is_string()) {
            mods.push_back(name.get<std::string>());
        }
    }
    bool changed = false;
    auto const folders = lua::modFolders({}, parts.document.path(), parts.options.data->home);
    std::vector<std::string> names;
    for (std::filesystem::path const& folder : lua::listMods(folders)) {
        names.push_back(folder.filename().string());
    }
    for (std::string const& name : mods) { // also one that is nowhere, so that it can be taken out
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            names.push_back(name);
        }
    }
    for (std::string const& name : names) {
        auto const at = std::find(mods.begin(), mods.end(), name);
        bool on = at != mods.end();
        if (render::checkBox(name.c_str(), &on)) {
            if (on) {
                mods.push_back(name);
            } else {
                mods.erase(at);
            }
            changed = true;
        }
        parts.context.layout.item("mod " + name);
    }
    if (changed) {
        parts.run([&](Json const& level) { return edit::setMods(level, mods); });
    }
    smallCaption(words::modsTip);
}

} // namespace

void drawLevelPage(EditParts& parts) {
    drawTexts(parts);
    drawToolboxRows(parts);
    drawTeachingSteps(parts);
    drawWorld(parts);
    drawMods(parts);
    drawTranslations(parts);
}

} // namespace trembler::ui
