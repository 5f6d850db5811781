#include "game/ui/edit/commands/edit_actions.hpp"
#include "game/ui/edit/edit_words.hpp"
#include "game/ui/shared/texts.hpp"

#include <utility>

namespace trembler::ui::actions {

using render::ToastKind;

void leaveFor(EditParts& parts, std::function<void(EditParts&)> const& then) {
    if (parts.document.modified() && !parts.document.readOnly()) {
        parts.dialogs.askUnsaved(then);
    } else {
        then(parts);
    }
}

void newLevel(EditParts& parts) {
    leaveFor(parts, [](EditParts& p) { p.newLevel(); });
}

void openLevel(EditParts& parts) {
    leaveFor(parts, [](EditParts& p) {
        auto const& path = p.document.path();
        auto const& last = p.context.edited; // that of a level which was left a moment ago
        p.browser.begin(FileBrowser::Purpose::open, !path.empty()  ? path.parent_path()
                                                    : last.empty() ? p.options.data->home / "levels"
                                                                   : last);
    });
}

bool saveTo(EditParts& parts, std::filesystem::path const& path, edit::LevelDocument::Overwrite overwrite) {
    edit::SaveResult const result =
        path.empty() ? parts.document.save(overwrite) : parts.document.saveAs(path, overwrite);
    if (result.ok()) {
        parts.autosave->close();
        parts.context.edited = parts.document.path().parent_path();
        parts.tell(words::savedTo(parts.document.path().filename().string()), ToastKind::Success);
        if (auto const next = std::exchange(parts.afterSaving, {})) {
            next(parts);
        }
        return true;
    }
    if (result.kind == edit::SaveResult::Kind::conflict) {
        parts.dialogs.askConflict(translated(result.message), path);
    } else {
        // Until it is saved, the unsaved work is kept as it is at any other time.
        parts.context.toasts.add(result.error ? notWritten(Owned::level, *result.error)
                                              : translated(result.message),
                                 ToastKind::Trouble, 10);
        parts.giveUpLeaving();
    }
    return false;
}

bool saveNow(EditParts& parts) {
    if (parts.document.path().empty() || parts.document.readOnly()) {
        saveAs(parts);
        return false;
    }
    return saveTo(parts, {}, edit::LevelDocument::Overwrite::no);
}

void save(EditParts& parts) {
    saveNow(parts);
}

void saveAs(EditParts& parts) {
    std::filesystem::path start = parts.document.path();
    if (start.empty()) {
        start = parts.dialogs.proposed();
    }
    if (start.empty()) {
        std::error_code ignored;
        auto const& last = parts.context.edited;
        start = (last.empty() ? std::filesystem::current_path(ignored) : last) / "my-level.json";
    }
    parts.browser.begin(FileBrowser::Purpose::saveAs, start);
}

void showPalette(EditParts& parts) {
    parts.palette.begin();
}

void openMenu(EditParts& parts) {
    parts.request = request::OpenMenu{MenuPage::main};
}

void switchFullscreen(EditParts& parts) {
    parts.request = request::SwitchFullscreen{};
}

void back(EditParts& parts) {
    if (parts.panelKeys) {
        parts.panelKeys = false;
    } else if (!parts.partInHand.empty()) {
        parts.partInHand.clear();
    } else if (parts.tool != Tool::select) {
        parts.tool = Tool::select;
    } else if (!parts.selection.piece().empty()) {
        parts.selection.choosePiece("");
    } else if (!parts.selection.empty()) {
        parts.selection.clear();
    } else {
        openMenu(parts);
    }
}

void switchSnap(EditParts& parts) {
    parts.snapping.on = !parts.snapping.on;
}
void switchNames(EditParts& parts) {
    parts.names = !parts.names;
}
void switchElectricity(EditParts& parts) {
    parts.electricity = !parts.electricity;
}
bool snaps(EditParts const& parts) {
    return parts.snapping.on;
}
bool showsNames(EditParts const& parts) {
    return parts.names;
}
bool showsElectricity(EditParts const& parts) {
    return parts.electricity;
}
void focusPanel(EditParts& parts) {
    parts.panelKeys = !parts.panelKeys;
}

} // namespace trembler::ui::actions
