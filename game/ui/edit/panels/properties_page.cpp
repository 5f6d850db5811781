#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/fields/field_widgets.hpp"
#include "game/ui/edit/fields/page_elements.hpp"
#include "game/ui/edit/fields/part_choice.hpp"
#include "game/ui/edit/fields/property_rows.hpp"
#include "game/ui/edit/panels/side_panel.hpp"
#include "game/ui/edit/view/edit_geometry.hpp"
#include "game/ui/shared/texts.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "puzzle/edit/commands/connect.hpp"
#include "puzzle/edit/commands/contents.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/commands/properties.hpp"
#include "puzzle/edit/tree/part_statements.hpp"
#include "render/panels/cards.hpp"
#include "render/panels/check_box.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>

namespace trembler::ui {
namespace {

using namespace render;
using edit::Json;

void drawNameAndPart(EditParts& parts) {
    std::vector<std::string> const names = parts.selected();
    if (names.size() == 1) {
        std::string name = names.front();
        fieldName(words::nameField, "");
        if (committedText(parts, "object name", name)) {
            parts.run([&](Json const& level) {
                return edit::renameObject(*parts.data, level, names.front(), name);
            });
        }
    } else {
        ImGui::TextUnformatted(words::severalObjects(names.size()).c_str());
    }
    Json const* const object = edit::findObject(parts.tree(), names.front());
    std::string part = object != nullptr && object->contains("part") && (*object)["part"].is_string()
                           ? (*object)["part"].get<std::string>()
                           : "";
    std::vector<std::string> choices = parts.data->parts.names();
    choices.insert(choices.begin(), "");
    fieldName(words::partField, words::partFieldTip);
    if (partChoice(parts, "object part", part, choices)) {
        runWidget(
            parts, [&](Json const& level) { return edit::setPart(level, names, part); }, false);
    }
    bool flipped = object != nullptr && object->contains("flipped") && (*object)["flipped"] == true;
    fieldName(words::mirroredField, words::mirroredTip);
    if (render::checkBox("##object flipped", &flipped)) {
        runWidget(
            parts, [&](Json const& level) { return edit::setFlipped(level, names, flipped); }, false);
    }
    parts.context.layout.item("object flipped");
}

/// Of objects that are made from composite parts, the piece that the rows below are about.
void drawPieceChoice(EditParts& parts, std::vector<edit::InspectedPiece> const& pieces) {
    std::string chosen = parts.selection.piece();
    auto const known = [&](std::string const& name) {
        return std::find_if(pieces.begin(), pieces.end(),
                            [&](auto const& piece) { return piece.name == name; });
    };
    if (!chosen.empty() && known(chosen) == pieces.end()) { // undone, or of another part now
        parts.selection.choosePiece("");
        chosen.clear();
    }
    std::vector<std::string> names{""};
    for (edit::InspectedPiece const& piece : pieces) {
        if (!piece.main || piece.stated) { // else it has the properties of the whole
            names.push_back(piece.name);
        }
    }
    if (names.size() == 1) {
        return;
    }
    auto const inWords = [&](std::string const& name) {
        auto const piece = known(name);
        return name + (piece != pieces.end() && piece->stated ? " *" : "");
    };
    fieldName(words::pieceField, words::pieceFieldTip);
    if (choiceField(parts, "piece", chosen, names, inWords)) {
        parts.selection.choosePiece(chosen);
    }
    if (!chosen.empty() && known(chosen)->stated &&
        smallButton(parts, words::resetPiece, "reset piece", words::resetPieceTip)) {
        runWidget(
            parts, [&](Json const& level) { return edit::resetPiece(level, parts.selected(), chosen); },
            false);
    }
}

void drawAddProperty(EditParts& parts) {
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    std::vector<edit::AddableProperty> addable;
    auto const entries = [&] {
        addable =
            edit::addableProperties(*parts.data, parts.tree(), parts.selected(), parts.selection.piece());
        std::sort(addable.begin(), addable.end(), [](auto const& one, auto const& other) {
            return std::string_view(text(one.name)) < std::string_view(text(other.name));
        });
        std::vector<DropDown::Entry> all;
        for (edit::AddableProperty const& property : addable) {
            all.push_back({text(property.name), " = " + std::string(property.key), text(property.help)});
        }
        return all;
    };
    if (auto const chosen = parts.dropDown.draw(parts, "add property", words::addProperty, entries)) {
        runWidget(
            parts,
            [&](Json const& level) {
                return edit::addProperty(*parts.data, level, parts.selected(), addable[*chosen].key,
                                         parts.selection.piece());
            },
            false);
    }
}

/// Whether the objects stay where they are, which is asked more often than anything else about them.
void drawFixed(EditParts& parts, std::vector<edit::InspectedProperty> const& properties) {
    std::string const key(propertyInfo<Fixed>().text.key);
    auto const found = std::find_if(properties.begin(), properties.end(),
                                    [&](edit::InspectedProperty const& one) { return one.key == key; });
    bool const listed = found != properties.end();
    bool const mixed = listed && found->origin == edit::ValueOrigin::mixed;
    bool on = listed && !mixed && found->origin != edit::ValueOrigin::removed;
    bool const was = on;
    std::string const name(propertyInfo<Fixed>().text.name);
    std::string const help(propertyInfo<Fixed>().text.meaning);
    fieldName(text(name), text(help) + (mixed ? std::string("\n") + words::severalValues : std::string()));
    bool const changed = render::checkBox("##object fixed", &on);
    parts.context.layout.item("object fixed");
    if (!changed) {
        return;
    }
    std::string const piece = parts.selection.piece();
    runWidget(
        parts,
        [&](Json const& level) {
            if (was) {
                return edit::removeProperty(*parts.data, level, parts.selected(), key, piece);
            }
            return listed && !mixed ? edit::resetProperty(*parts.data, level, parts.selected(), key, piece)
                                    : edit::addProperty(*parts.data, level, parts.selected(), key, piece);
        },
        false);
}

/// Of many objects these take long to gather, so while they are dragged those from before the drag are shown.
InspectedSelection const& inspectedSelection(EditParts& parts) {
    InspectedSelection& seen = parts.inspected;
    std::string const& piece = parts.selection.piece();
    bool const sameObjects = seen.known && seen.names == parts.selected() && seen.piece == piece;
    bool const current = sameObjects && seen.revision == parts.document.revision();
    bool const dragged =
        sameObjects && seen.names.size() > 1 && parts.changing() && !ImGui::IsAnyItemActive();
    if (!current && !dragged) {
        seen = {parts.document.revision(),
                parts.selected(),
                piece,
                edit::inspectObjects(*parts.data, parts.tree(), parts.selected(), piece),
                edit::inspectPieces(*parts.data, parts.tree(), parts.selected()),
                true};
    }
    return seen;
}

void drawObjectProperties(EditParts& parts) {
    drawNameAndPart(parts);
    // Copied, as a widget may change the selection.
    auto const pieces = inspectedSelection(parts).pieces;
    drawPieceChoice(parts, pieces);
    auto const properties = inspectedSelection(parts).properties;
    drawFixed(parts, properties);
    drawAddProperty(parts);
    edit::InspectedProperty const* scripts = nullptr;
    for (edit::InspectedProperty const& property : properties) {
        if (property.key == "scripts" && parts.data->scripts != nullptr) {
            scripts = &property;
        } else {
            drawObjectProperty(parts, property);
        }
    }
    drawScripts(parts, scripts);
}

void drawJoint(EditParts& parts) {
    std::size_t const joint = indexOfPath(parts.selection.path());
    auto const fields = edit::inspectJoint(*parts.data, parts.tree(), joint);
    if (fields.empty()) {
        return caption(words::nothingSelected);
    }
    std::string name;
    for (edit::JointEntry const& entry : edit::jointsOf(parts.tree())) {
        if (entry.index == joint) {
            name = entry.name;
        }
    }
    fieldName(words::nameField, "");
    if (committedText(parts, "joint name", name)) {
        runWidget(
            parts, [&](Json const& level) { return edit::renameJoint(*parts.data, level, joint, name); },
            false);
    }
    for (edit::InspectedField const& field : fields) {
        if (auto const value = fieldWidget(parts, field, "joint" + field.place)) {
            bool const continuous = field.type != FieldType::choice && field.type != FieldType::object;
            runWidget(
                parts,
                [&](Json const& level) {
                    return edit::setJointField(*parts.data, level, joint, field.place, *value);
                },
                continuous);
        }
    }
}

void drawConnection(EditParts& parts) {
    std::size_t const index = indexOfPath(parts.selection.path());
    auto const all = edit::connectionsOf(parts.tree());
    auto const found = std::find_if(all.begin(), all.end(), [&](auto const& c) { return c.index == index; });
    if (found == all.end()) {
        return caption(words::nothingSelected);
    }
    edit::ConnectionEntry entry = *found;
    std::vector<std::string> const names = edit::namesOfObjectsAndPieces(*parts.data, parts.tree());
    bool changed = false;
    fieldName(words::fromField, "");
    changed = choiceField(parts, "connection from", entry.a, names);
    fieldName(words::toField, "");
    changed = choiceField(parts, "connection to", entry.b, names) || changed;
    fieldName(words::kindField, words::kindFieldTip);
    changed = committedText(parts, "connection kind", entry.kind) || changed;
    if (changed) {
        runWidget(
            parts,
            [&](Json const& level) {
                return edit::changeConnection(level, index, entry.a, entry.b, entry.kind);
            },
            false);
    }
}

void drawPlacing(EditParts& parts) {
    for (SceneArea const& area : sceneAreas(parts)) {
        if (area.selected) {
            if (auto const changed = areaFields(parts, area.area, "area")) {
                runWidget(
                    parts,
                    [&](Json const& level) {
                        return edit::setPlacingArea(level, indexOfPath(area.path), *changed);
                    },
                    true);
            }
        }
    }
}

/// These are in the line at the bottom, too; here they can be reached by the keyboard.
void drawToolSettings(EditParts& parts) {
    pageHeading(words::toolSettings);
    fieldName(words::gridStep, words::snapTip);
    static_cast<void>(numberField(parts, "grid field", parts.snapping.grid, Snapping::smallestGrid,
                                  Snapping::largestGrid, "m"));
    fieldName(words::angleStep, words::snapTip);
    static_cast<void>(numberField(parts, "angle field", parts.snapping.angleDegrees, Snapping::smallestAngle,
                                  Snapping::largestAngle, "°"));
    fieldName(words::radius, "");
    static_cast<void>(numberField(parts, "radius field", parts.capsuleRadius, 0.005, 10, "m"));
    std::vector<std::string> forms;
    for (std::string_view const form : choiceNames<JointForm>) {
        forms.emplace_back(form);
    }
    fieldName(words::jointField, "");
    static_cast<void>(choiceField(parts, "joint form field", parts.jointForm, forms, shownChoice));
}

} // namespace

void drawPropertiesPage(EditParts& parts) {
    if (!parts.selected().empty()) {
        return drawObjectProperties(parts);
    }
    switch (parts.selection.kind()) {
    case EntryKind::joint:
        return drawJoint(parts);
    case EntryKind::connection:
        return drawConnection(parts);
    case EntryKind::placing:
        return drawPlacing(parts);
    default:
        caption(words::nothingSelected);
        drawToolSettings(parts);
    }
}

} // namespace trembler::ui
