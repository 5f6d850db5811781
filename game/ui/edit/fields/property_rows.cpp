#include "game/ui/edit/fields/property_rows.hpp"

#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/fields/field_widgets.hpp"
#include "game/ui/edit/fields/page_elements.hpp"
#include "game/ui/shared/texts.hpp"
#include "puzzle/edit/commands/properties.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"

#include <string>
#include <utility>

namespace trembler::ui {
namespace {

using namespace render;
using edit::InspectedField;
using edit::Json;

/// Whose fields are drawn: of the selected objects, of the piece of them that is selected, or of the world.
struct Owner {
    EditParts& parts;
    bool world = false;

    [[nodiscard]] edit::Command set(Json const& level, std::string const& key, std::string const& place,
                                    Json const& value) const {
        return world ? edit::setWorldField(*parts.data, level, key, place, value)
                     : edit::setField(*parts.data, level, parts.selected(), key, place, value,
                                      parts.selection.piece());
    }
};

void drawField(Owner const& owner, std::string const& key, InspectedField const& field);

/// The entries of a list, each with its fields and a button that removes it; and one that adds.
void drawList(Owner const& owner, std::string const& key, InspectedField const& field) {
    EditParts& parts = owner.parts;
    for (std::size_t i = 0; i < field.entries.size(); ++i) {
        InspectedField const& entry = field.entries[i];
        std::string const item = key + entry.place;
        ImGui::PushID(static_cast<int>(i));
        if (entry.entries.empty()) {
            drawField(owner, key, entry);
        } else {
            ImGui::TextDisabled("%s %zu", shownField(field.name).c_str(), i + 1);
            for (InspectedField const& inner : entry.entries) {
                drawField(owner, key, inner);
            }
        }
        if (!owner.world && field.entries.size() > 1 &&
            smallButton(parts, words::removeIt, "remove " + item)) {
            runWidget(
                parts,
                [&](Json const& level) {
                    return edit::removeListEntry(*parts.data, level, parts.selected(), key, field.place, i,
                                                 parts.selection.piece());
                },
                false);
        }
        ImGui::PopID();
    }
    // Lists of several objects that differ in length have no common end.
    if (owner.world || (field.mixed && field.entries.empty())) {
        return;
    }
    if (field.entries.empty()) {
        fieldName(shownField(field.name), text(field.help));
    }
    if (smallButton(parts, words::addEntryOf(shownField(field.name)).c_str(), "add " + key + field.place)) {
        Json const entry = field.value.is_array() && !field.value.empty() ? field.value.back() : Json();
        runWidget(
            parts,
            [&](Json const& level) {
                return edit::addListEntry(*parts.data, level, parts.selected(), key, field.place, entry,
                                          parts.selection.piece());
            },
            false);
    }
}

/// The place that a new value is for, and the value: of several objects in different places one coordinate,
/// so that each keeps its other one.
std::pair<std::string, Json> changeOf(InspectedField const& field, Json const& value) {
    bool const several = field.mixed && field.type == FieldType::vector && field.place.empty();
    if (several && field.value.is_array() && field.value.size() == 2 && value[1] == field.value[1]) {
        return {"/0", value[0]};
    }
    if (several && field.value.is_array() && field.value.size() == 2 && value[0] == field.value[0]) {
        return {"/1", value[1]};
    }
    return {field.place, value};
}

void drawField(Owner const& owner, std::string const& key, InspectedField const& field) {
    if (field.type == FieldType::list) {
        return drawList(owner, key, field);
    }
    std::string const item = key + field.place;
    if (auto const value = fieldWidget(owner.parts, field, item)) {
        auto const [place, changed] = changeOf(field, *value);
        runWidget(
            owner.parts,
            [&, at = place, to = changed](Json const& level) { return owner.set(level, key, at, to); },
            isContinuous(field));
    }
}

void drawHeading(edit::InspectedProperty const& property) {
    bool const own = property.origin == edit::ValueOrigin::own ||
                     property.origin == edit::ValueOrigin::changed ||
                     property.origin == edit::ValueOrigin::removed;
    ImGui::PushFont(theme().fonts.strong);
    ImGui::AlignTextToFramePadding(); // buttons may follow
    ImGui::PushStyleColor(ImGuiCol_Text, imColour4(own ? palette::ink : palette::inkSoft));
    ImGui::TextUnformatted(text(property.name));
    ImGui::PopStyleColor();
    ImGui::PopFont();
    if (ImGui::IsItemHovered()) {
        std::string const origin = property.origin == edit::ValueOrigin::part      ? words::fromPart
                                   : property.origin == edit::ValueOrigin::removed ? words::takenAway
                                   : property.origin == edit::ValueOrigin::mixed   ? words::severalValues
                                                                                   : "";
        ImGui::SetTooltip("%s%s%s", text(property.help), origin.empty() ? "" : "\n", origin.c_str());
    }
}

} // namespace

void drawObjectProperty(EditParts& parts, edit::InspectedProperty const& property) {
    ImGui::PushID(property.key.c_str());
    ImGui::Dummy({0, scaled(1)});
    drawHeading(property);
    // A property that only the object states has no value of its part to return to.
    if (property.canReset && property.origin != edit::ValueOrigin::own) {
        besideIfRoom(words::reset);
        if (smallButton(parts, words::reset, "reset " + property.key, words::resetTip)) {
            runWidget(
                parts,
                [&](Json const& level) {
                    return edit::resetProperty(*parts.data, level, parts.selected(), property.key,
                                               parts.selection.piece());
                },
                false);
        }
    }
    if (property.canRemove && property.place == PropertyPlace::properties) {
        besideIfRoom(words::removeShort);
        if (smallButton(parts, words::removeShort, "remove " + property.key, words::removeTip)) {
            runWidget(
                parts,
                [&](Json const& level) {
                    return edit::removeProperty(*parts.data, level, parts.selected(), property.key,
                                                parts.selection.piece());
                },
                false);
        }
    }
    for (InspectedField const& field : property.fields) {
        drawField({parts, false}, property.key, field);
    }
    ImGui::PopID();
}

void drawWorldProperty(EditParts& parts, edit::InspectedProperty const& property) {
    ImGui::PushID(property.key.c_str());
    drawHeading(property);
    if (property.canReset) {
        besideIfRoom(words::reset);
        if (smallButton(parts, words::reset, "reset " + property.key, words::resetTip)) {
            parts.run([&](Json const& level) { return edit::resetWorldProperty(level, property.key); });
        }
    }
    for (InspectedField const& field : property.fields) {
        drawField({parts, true}, property.key, field);
    }
    ImGui::PopID();
}

} // namespace trembler::ui
