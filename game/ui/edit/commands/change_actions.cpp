#include "game/ui/edit/commands/edit_actions.hpp"
#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/view/edit_geometry.hpp"
#include "game/ui/shared/commands/named_keys.hpp"
#include "game/ui/shared/shown_faults.hpp"
#include "game/ui/shared/texts.hpp"
#include "puzzle/edit/commands/arrange.hpp"
#include "puzzle/edit/commands/clipboard.hpp"
#include "puzzle/edit/commands/connect.hpp"
#include "puzzle/edit/commands/contents.hpp"
#include "puzzle/edit/commands/editor_state.hpp"
#include "puzzle/edit/commands/goals.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/commands/own_parts.hpp"
#include "puzzle/edit/commands/properties.hpp"
#include "puzzle/edit/inspect/inspector.hpp"

#include <SDL_clipboard.h>

#include <algorithm>
#include <cstdlib>

namespace trembler::ui::actions {
namespace {

using edit::Json;
using render::ToastKind;

std::string clipboardText() {
    char* const text = SDL_GetClipboardText();
    std::string const copied = text == nullptr ? "" : text;
    SDL_free(text);
    return copied;
}

/// Something that can be selected by itself: an object by its name, anything else by its path.
struct SelectableEntry {
    EntryKind kind = EntryKind::none;
    std::string path;
    friend bool operator==(SelectableEntry const&, SelectableEntry const&) = default;
};

std::vector<SelectableEntry> selectableEntries(EditParts const& parts) {
    std::vector<SelectableEntry> all;
    for (std::string const& name : edit::objectNames(parts.tree())) {
        all.push_back({EntryKind::none, name});
    }
    for (edit::JointEntry const& joint : edit::jointsOf(parts.tree())) {
        all.push_back({EntryKind::joint, "/joints/" + std::to_string(joint.index)});
    }
    for (edit::ConnectionEntry const& link : edit::connectionsOf(parts.tree())) {
        all.push_back({EntryKind::connection, "/connections/" + std::to_string(link.index)});
    }
    for (SceneArea const& area : sceneAreas(parts)) {
        all.push_back({area.kind, area.path});
    }
    return all;
}

/// The number at the end of a JSON pointer.
std::size_t indexAtEnd(std::string const& path) {
    return static_cast<std::size_t>(std::strtoul(path.c_str() + path.rfind('/') + 1, nullptr, 10));
}

/// Removes the statements about the selected piece, as the piece itself belongs to its part. False if no
/// piece of the objects is selected.
bool deletePiece(EditParts& parts) {
    auto const pieces = edit::inspectPieces(*parts.data, parts.tree(), parts.selected());
    std::string const chosen = parts.selection.piece();
    auto const piece =
        std::find_if(pieces.begin(), pieces.end(), [&](auto const& one) { return one.name == chosen; });
    if (chosen.empty() || piece == pieces.end()) {
        return false;
    }
    if (piece->stated) {
        parts.run([&](Json const& level) { return edit::resetPiece(level, parts.selected(), chosen); });
    } else {
        parts.tell(words::pieceStays(namedKeys({"back"}, parts.context.keys)));
    }
    return true;
}

} // namespace

bool canUndo(EditParts const& parts) {
    return parts.document.canUndo();
}
bool canRedo(EditParts const& parts) {
    return parts.document.canRedo();
}
bool hasSelection(EditParts const& parts) {
    return !parts.selected().empty();
}
bool hasSeveral(EditParts const& parts) {
    return parts.selected().size() > 1;
}
bool hasThree(EditParts const& parts) {
    return parts.selected().size() > 2;
}
bool canDelete(EditParts const& parts) {
    return !parts.selection.empty();
}
bool canPaste(EditParts const&) {
    return edit::canPaste(clipboardText());
}
bool canMakePart(EditParts const& parts) {
    return hasSelection(parts);
}

void undo(EditParts& parts) {
    std::string const name = parts.document.undoName();
    if (parts.document.undo()) {
        parts.tell(words::undone(translated(name)));
    }
}

void redo(EditParts& parts) {
    std::string const name = parts.document.redoName();
    if (parts.document.redo()) {
        parts.tell(words::redone(translated(name)));
    }
}

void copy(EditParts& parts) {
    try {
        std::string const text = edit::copiedText(*parts.data, parts.tree(), parts.selected());
        if (SDL_SetClipboardText(text.c_str()) != 0) {
            parts.tell(SDL_GetError(), ToastKind::Trouble);
        }
    } catch (edit::CommandError const& error) {
        parts.tell(shownError(error), ToastKind::Trouble);
    }
}

void cut(EditParts& parts) {
    copy(parts);
    parts.run([&](Json const& level) { return edit::cutObjects(*parts.data, level, parts.selected()); });
}

void paste(EditParts& parts) {
    std::string const text = clipboardText();
    // Where the mouse is; without it, as by the keyboard alone, where it was copied from.
    std::optional<Vec2> at;
    if (parts.pointer.inside && !parts.pointer.overCard && !parts.panelKeys) {
        at = parts.snapping.place(parts.pointer.world);
    }
    parts.run([&](Json const& level) { return edit::pasteText(*parts.data, level, text, at); });
}

void duplicate(EditParts& parts) {
    double const step = std::max(4 * parts.snapping.grid, 0.1);
    parts.run([&](Json const& level) {
        return edit::duplicateObjects(*parts.data, level, parts.selected(), {step, -step});
    });
}

void deleteSelected(EditParts& parts) {
    if (deletePiece(parts)) {
        return;
    }
    if (hasSelection(parts)) {
        parts.run(
            [&](Json const& level) { return edit::removeObjects(*parts.data, level, parts.selected()); });
        return;
    }
    std::string const path = parts.selection.path();
    bool done = false;
    switch (parts.selection.kind()) {
    case EntryKind::joint:
        done = parts.run(
            [&](Json const& level) { return edit::removeJoints(*parts.data, level, {indexAtEnd(path)}); });
        break;
    case EntryKind::connection:
        done =
            parts.run([&](Json const& level) { return edit::removeConnections(level, {indexAtEnd(path)}); });
        break;
    case EntryKind::placing:
        done = parts.run([&](Json const& level) { return edit::removePlacingArea(level, indexAtEnd(path)); });
        break;
    case EntryKind::goalArea:
        done = parts.run([&](Json const& level) { return edit::removeGoal(level, path, parts.goalTree); });
        break;
    case EntryKind::none:
        break;
    }
    if (done) {
        parts.selection.clear();
    }
}

void selectAll(EditParts& parts) {
    std::vector<std::string> names;
    for (std::string const& name : edit::unlocked(parts.tree(), edit::objectNames(parts.tree()))) {
        if (!edit::isHidden(parts.tree(), name)) {
            names.push_back(name);
        }
    }
    parts.selection.set(std::move(names));
}

void selectNext(EditParts& parts) {
    std::vector<SelectableEntry> const all = selectableEntries(parts);
    if (all.empty()) {
        return;
    }
    bool const back = parts.context.shiftHeld();
    SelectableEntry const present{parts.selection.kind(), parts.selected().empty() ? parts.selection.path()
                                                                                   : parts.selected().back()};
    auto const at = std::find(all.begin(), all.end(), present);
    auto const index = static_cast<std::size_t>(at - all.begin());
    std::size_t next = back ? all.size() - 1 : 0;
    if (at != all.end()) {
        next = (index + (back ? all.size() - 1 : 1)) % all.size();
    }
    if (all[next].kind == EntryKind::none) {
        parts.selection.set({all[next].path});
    } else {
        parts.selection.choose(all[next].kind, all[next].path);
    }
}

void selectAlso(EditParts& parts) {
    std::vector<std::string> const names = edit::objectNames(parts.tree());
    bool const back = parts.context.shiftHeld();
    auto const at = std::find(names.begin(), names.end(), hasSelection(parts) ? parts.selected().back() : "");
    std::size_t index =
        at == names.end() ? (back ? 0 : names.size() - 1) : static_cast<std::size_t>(at - names.begin());
    for (std::size_t i = 0; i < names.size(); ++i) {
        index = (index + (back ? names.size() - 1 : 1)) % names.size();
        if (!parts.selection.has(names[index])) {
            return parts.selection.add(names[index]);
        }
    }
}

void askPartName(EditParts& parts) {
    parts.dialogs.askPartName("my " + parts.selected().front());
}

void makePart(EditParts& parts, std::string const& name, bool putHere) {
    std::vector<std::string> const names = parts.selected();
    try {
        Json const part = edit::partFrom(*parts.data, parts.tree(), names, names.front(), {name, name, ""});
        auto const file = edit::writePart(ownPartsFolder(), part);
        parts.tell(words::partMade(name, shownPath(file)), ToastKind::Success);
    } catch (OutputError const& error) {
        return parts.tell(notWritten(Owned::part, error), ToastKind::Trouble);
    } catch (std::exception const& error) { // CommandError, in words for people
        return parts.tell(shownError(error), ToastKind::Trouble);
    }
    parts.reloadParts();
    if (putHere && parts.data->parts.find(name) != nullptr) {
        parts.run([&](Json const& level) {
            return edit::replaceByPart(*parts.data, level, names, names.front(), name);
        });
    }
}

} // namespace trembler::ui::actions
