#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/fields/field_widgets.hpp"
#include "game/ui/edit/fields/page_elements.hpp"
#include "game/ui/edit/fields/part_choice.hpp"
#include "game/ui/edit/panels/side_panel.hpp"
#include "game/ui/shared/texts.hpp"
#include "puzzle/edit/commands/contents.hpp"
#include "puzzle/edit/commands/editor_state.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/tree/part_statements.hpp"
#include "render/panels/check_box.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <array>

namespace trembler::ui {
namespace {

using namespace render;
using edit::Json;

struct LessonStepKind {
    char const* key; // in level files
    char const* id;  // of its text
};
constexpr std::array<LessonStepKind, 5> stepKinds{{{"place", "step.place"},
                                                   {"wire", "step.wire"},
                                                   {"run", "step.run"},
                                                   {"grab", "step.grab"},
                                                   {"cut", "step.cut"}}};

std::string shownStep(std::string const& key) {
    auto const found = std::find_if(stepKinds.begin(), stepKinds.end(),
                                    [&](LessonStepKind const& kind) { return kind.key == key; });
    return found == stepKinds.end() ? key : text(found->id);
}

std::string kindOfStep(Json const& step) {
    for (LessonStepKind const& kind : stepKinds) {
        if (step.is_object() && step.contains(kind.key)) {
            return kind.key;
        }
    }
    return {};
}

std::vector<std::string> partsOfToolbox(Json const& tree) {
    std::vector<std::string> names;
    if (tree.contains("toolbox") && tree["toolbox"].is_array()) {
        for (Json const& tool : tree["toolbox"]) {
            if (tool.is_object() && tool.contains("part") && tool["part"].is_string()) {
                names.push_back(tool["part"].get<std::string>());
            }
        }
    }
    return names;
}

/// A name among several; true when another one was chosen.
bool nameChoice(EditParts& parts, char const* title, std::string const& item, Json& name,
                std::vector<std::string> const& names) {
    std::string chosen = name.is_string() ? name.get<std::string>() : "";
    fieldName(title, "");
    if (!choiceField(parts, item, chosen, names)) {
        return false;
    }
    name = chosen;
    return true;
}

/// Two numbers in m; true while they change.
bool placeFields(EditParts& parts, std::string const& item, Json& place) {
    std::array<double, 2> at{};
    for (std::size_t i = 0; i < 2; ++i) {
        at[i] = place.is_array() && place.size() == 2 && place[i].is_number() ? place[i].get<double>() : 0;
    }
    fieldName(words::placeField, "");
    float const half = 0.5F * (ImGui::GetContentRegionAvail().x - scaled(4));
    ImGui::SetNextItemWidth(half);
    bool changed = numberField(parts, item + " x", at[0], -1e4, 1e4, "m");
    ImGui::SameLine(0, scaled(4));
    ImGui::SetNextItemWidth(half);
    changed = numberField(parts, item + " y", at[1], -1e4, 1e4, "m") || changed;
    if (changed) {
        place = Json::array({at[0], at[1]});
    }
    return changed;
}

struct StepChange {
    bool touched = false;
    bool continuous = false; ///< a number that is being dragged
};

/// The fields of a step of that kind.
StepChange editStep(EditParts& parts, std::string const& kind, std::string const& item, Json& step) {
    StepChange change;
    auto const numbers = [&](bool touched) {
        change.touched = change.touched || touched;
        change.continuous = change.continuous || touched;
    };
    auto const objects = edit::namesOfObjectsAndPieces(*parts.data, parts.tree());
    if (kind == "place") {
        std::string part = step[kind].is_string() ? step[kind].get<std::string>() : "";
        fieldName(words::partField, "");
        if (partChoice(parts, item + " part", part, partsOfToolbox(parts.tree()))) {
            step[kind] = part;
            change.touched = true;
        }
        numbers(placeFields(parts, item + " at", step["at"]));
        double angle =
            step.contains("angle_deg") && step["angle_deg"].is_number() ? step["angle_deg"].get<double>() : 0;
        fieldName(words::angleStep, "");
        if (numberField(parts, item + " angle", angle, -360, 360, "°")) {
            step["angle_deg"] = angle;
            numbers(true);
        }
        bool flipped = step.contains("flipped") && step["flipped"] == true;
        if (render::checkBox((std::string(words::mirroredField) + "##" + item).c_str(), &flipped)) {
            step["flipped"] = flipped;
            change.touched = true;
        }
        parts.context.layout.item(item + " flipped");
    } else if (kind == "grab") {
        change.touched = nameChoice(parts, words::objectField, item + " object", step[kind], objects);
        numbers(placeFields(parts, item + " to", step["to"]));
    } else if ((kind == "wire" || kind == "cut") && step[kind].is_array() && step[kind].size() == 2) {
        change.touched = nameChoice(parts, words::fromField, item + " from", step[kind][0], objects);
        change.touched =
            nameChoice(parts, words::toField, item + " to", step[kind][1], objects) || change.touched;
    }
    return change;
}

void drawStep(EditParts& parts, Json const& stated, std::size_t index, std::size_t count) {
    std::string const item = "step " + std::to_string(index);
    ImGui::PushID(item.c_str());
    std::string const kind = kindOfStep(stated);
    ImGui::Text("%zu. %s", index + 1, shownStep(kind).c_str());
    Json step = stated;
    StepChange const change = editStep(parts, kind, item, step);
    if (change.touched) {
        runWidget(
            parts, [&](Json const& level) { return edit::setStep(level, index, step); }, change.continuous);
    }
    if (smallButton(parts, words::removeIt, item + " remove")) {
        parts.run([&](Json const& level) { return edit::removeStep(level, index); });
    }
    if (auto const to = orderArrows(parts, item, index, count)) {
        parts.run([&](Json const& level) { return edit::moveStep(level, index, *to); });
    }
    ImGui::PopID();
}

void drawAddStep(EditParts& parts) {
    std::vector<std::string> kinds;
    for (LessonStepKind const& kind : stepKinds) {
        kinds.emplace_back(kind.key);
    }
    std::string chosen;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    bool const added = choiceField(parts, "add step", chosen, kinds, shownStep, words::addStep);
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("%s", words::addStepTip);
    }
    if (!added) {
        return;
    }
    std::vector<std::string> names;
    if (chosen == "place") {
        names = partsOfToolbox(parts.tree());
    } else {
        names = parts.selected();
        for (std::string const& name : edit::objectNames(parts.tree())) { // something to begin with
            if (std::find(names.begin(), names.end(), name) == names.end()) {
                names.push_back(name);
            }
        }
    }
    if (auto const step = edit::newStep(chosen, names, parts.middleOfView())) {
        parts.run([&](Json const& level) { return edit::addStep(level, *step); });
    } else {
        parts.tell(chosen == "place" ? words::stepNeedsPart : words::stepNeedsObjects);
    }
}

} // namespace

void drawTeachingSteps(EditParts& parts) {
    pageHeading(words::teachingHeading);
    // A copy, as a button changes the list.
    Json const steps = parts.tree().contains("teaching") && parts.tree()["teaching"].is_array()
                           ? parts.tree()["teaching"]
                           : Json::array();
    for (std::size_t i = 0; i < steps.size(); ++i) {
        drawStep(parts, steps[i], i, steps.size());
    }
    drawAddStep(parts);
}

} // namespace trembler::ui
