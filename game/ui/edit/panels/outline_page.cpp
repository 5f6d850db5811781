#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/fields/page_elements.hpp"
#include "game/ui/edit/panels/side_panel.hpp"
#include "game/ui/shared/texts.hpp"
#include "puzzle/edit/commands/connect.hpp"
#include "puzzle/edit/commands/editor_state.hpp"
#include "puzzle/edit/commands/objects.hpp"

#include <set>

namespace trembler::ui {
namespace {

void drawObjects(EditParts& parts) {
    std::set<std::string> const selected(parts.selected().begin(), parts.selected().end());
    for (std::string const& name : edit::objectNames(parts.tree())) {
        bool const locked = edit::isLocked(parts.tree(), name);
        bool const hidden = edit::isHidden(parts.tree(), name);
        std::string const label =
            name + (locked ? words::lockedMark : "") + (hidden ? words::hiddenMark : "") + "##" + name;
        if (ImGui::Selectable(label.c_str(), selected.contains(name))) {
            if (parts.context.shiftHeld() || parts.context.controlHeld()) {
                if (parts.selection.has(name)) {
                    parts.selection.remove(name);
                } else {
                    parts.selection.add(name);
                }
            } else {
                parts.selection.set(edit::withGroups(parts.tree(), {name}));
            }
        }
        parts.context.layout.item("object " + name);
        if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
            parts.tab = Tab::properties;
        }
    }
}

void drawEntry(EditParts& parts, EntryKind kind, std::string const& path, std::string const& label) {
    bool const chosen = parts.selection.kind() == kind && parts.selection.path() == path;
    if (ImGui::Selectable((label + "##" + path).c_str(), chosen)) {
        parts.selection.choose(kind, path);
    }
    parts.context.layout.item("entry " + path);
}

} // namespace

void drawOutlinePage(EditParts& parts) {
    pageHeading(words::objectsHeading);
    drawObjects(parts);
    auto const joints = edit::jointsOf(parts.tree());
    if (!joints.empty()) {
        pageHeading(words::jointsHeading);
    }
    for (edit::JointEntry const& joint : joints) {
        drawEntry(parts, EntryKind::joint, "/joints/" + std::to_string(joint.index),
                  joint.name + ": " + text(joint.form) + ", " + joint.a +
                      (joint.b.empty() ? std::string() : " – " + joint.b));
    }
    auto const connections = edit::connectionsOf(parts.tree());
    if (!connections.empty()) {
        pageHeading(words::connectionsHeading);
    }
    for (edit::ConnectionEntry const& connection : connections) {
        drawEntry(parts, EntryKind::connection, "/connections/" + std::to_string(connection.index),
                  connection.a + " – " + connection.b +
                      (connection.kind.empty() ? std::string() : " (" + connection.kind + ")"));
    }
}

} // namespace trembler::ui
