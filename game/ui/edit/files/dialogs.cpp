#include "game/ui/edit/files/dialogs.hpp"

#include "game/ui/edit/commands/edit_actions.hpp"
#include "game/ui/edit/edit_parts.hpp"
#include "game/ui/edit/edit_words.hpp"
#include "game/ui/shared/shown_faults.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>

namespace trembler::ui {
namespace {

using namespace render;

void beginDialog(UiContext& context, char const* name, char const* title, bool typing, float width = 420) {
    context.focus.begin(name, typing ? std::span<MenuKeys::Press const>() : context.menuKeys.presses(),
                        context.input.mouseMoved() != Point{});
    context.layout.beginCard(name, title, {.anchor = Anchor::Middle, .width = width});
    ImGui::Dummy({0, scaled(2)});
}

bool choice(UiContext& context, char const* label, char const* item, Icon icon,
            ButtonLook look = ButtonLook::Quiet, bool enabled = true) {
    bool const clicked = bigButton(label, {.icon = icon, .look = look, .width = -1, .enabled = enabled});
    context.layout.item(item);
    return context.focus.item() || clicked;
}

} // namespace

void Dialogs::askUnsaved(std::function<void(EditParts&)> then) {
    then_ = std::move(then);
    shown_ = Shown::unsaved;
}

void Dialogs::offerRecovery(std::vector<edit::Recovery> recoveries) {
    recoveries_ = std::move(recoveries);
    shown_ = recoveries_.empty() ? Shown::none : Shown::recovery;
}

void Dialogs::askPartName(std::string const& proposed) {
    name_ = proposed;
    fresh_ = true;
    shown_ = Shown::partName;
}

void Dialogs::askConflict(std::string message, std::filesystem::path path) {
    message_ = std::move(message);
    path_ = std::move(path);
    shown_ = Shown::conflict;
}

void Dialogs::drawUnsaved(EditParts& parts) {
    beginDialog(parts.context, "unsaved", words::unsavedTitle, false);
    caption(words::unsavedText);
    bool const save = choice(parts.context, words::saveAndGo, "save and go", Icon::Save, ButtonLook::Primary);
    bool const drop =
        choice(parts.context, words::dropChanges, "drop changes", Icon::Remove, ButtonLook::Danger);
    bool const stay = choice(parts.context, words::cancel, "stay", Icon::Cross);
    parts.context.layout.endCard();
    auto const then = then_;
    if (stay) {
        close();
        parts.giveUpLeaving();
    } else if (drop) {
        close();
        then(parts);
    } else if (save) {
        close();
        parts.afterSaving = then; // also after a question about the file
        actions::saveNow(parts);
    }
}

void Dialogs::drawRecovery(EditParts& parts) {
    beginDialog(parts.context, "recovery", words::recoveryTitle, false, 460);
    caption(words::recoveryText);
    edit::Recovery const& recovery = recoveries_.front();
    std::string const what = (recovery.title.empty() ? std::string(words::newLevel) : recovery.title) +
                             (recovery.level.empty() ? "" : "\n" + recovery.level.string());
    ImGui::TextWrapped("%s", what.c_str());
    bool const yes = choice(parts.context, words::recover, "recover", Icon::Undo, ButtonLook::Primary);
    bool const no =
        choice(parts.context, words::forgetRecovery, "forget recovery", Icon::Remove, ButtonLook::Danger);
    bool const later = choice(parts.context, words::later, "later", Icon::Cross);
    parts.context.layout.endCard();
    if (yes) {
        edit::Recovery const chosen = recovery;
        close();
        try {
            auto const own = parts.dataFor(chosen.level);
            parts.use(edit::recover(*own, chosen), own);
            parts.autosave->flush(parts.document);
            edit::discard(chosen);
        } catch (InputError const& error) {
            parts.tell(shownError(error), ToastKind::Trouble);
        }
    } else if (no) {
        edit::discard(recovery);
        recoveries_.erase(recoveries_.begin());
        if (recoveries_.empty()) {
            close();
        }
    } else if (later) {
        close();
    }
}

void Dialogs::drawReadOnly(EditParts& parts) {
    beginDialog(parts.context, "read only", words::readOnlyTitle, false, 560);
    caption(words::readOnly);
    ImGui::BeginChild("faults", {0, scaled(180)});
    for (Diagnostic const& fault : parts.document.faults()) {
        ImGui::TextWrapped("%s", shownFault(fault).c_str());
    }
    ImGui::EndChild();
    std::filesystem::path const& path = parts.document.path();
    bool const last =
        lastGood_ && choice(parts.context, words::takeLastGood(path.filename().string() + "~").c_str(),
                            "take last good", Icon::Undo, ButtonLook::Primary);
    bool const look = choice(parts.context, words::understood, "understood", Icon::Eye,
                             lastGood_ ? ButtonLook::Quiet : ButtonLook::Primary);
    bool const nevertheless =
        parts.document.mayBeEdited() && choice(parts.context, words::editNevertheless, "edit nevertheless",
                                               Icon::Settings, ButtonLook::Danger);
    parts.context.layout.endCard();
    if (nevertheless) {
        parts.document.editNevertheless();
    }
    if (look || nevertheless || last) {
        close();
    }
    if (last) {
        parts.takeLastGood();
    }
}

void Dialogs::drawPartName(EditParts& parts) {
    beginDialog(parts.context, "part name", words::makePartTitle, parts.context.gui.wantsKeyboard());
    caption(words::makePartText);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (fresh_) {
        ImGui::SetKeyboardFocusHere();
        fresh_ = false;
    }
    bool const entered = textField("##part", name_, 80, true);
    parts.context.layout.item("part name field");
    fresh_ = parts.context.focus.item();
    bool const make =
        choice(parts.context, words::makePart, "make part", Icon::Tick, ButtonLook::Primary, !name_.empty());
    bool const here = choice(parts.context, words::makePartHere, "make part here", Icon::Plus,
                             ButtonLook::Quiet, !name_.empty());
    bool const cancelled = choice(parts.context, words::cancel, "cancel part", Icon::Cross);
    parts.context.layout.endCard();
    if (cancelled) {
        close();
    } else if ((make || here || entered) && !name_.empty()) {
        close();
        actions::makePart(parts, name_, here);
    }
}

void Dialogs::drawConflict(EditParts& parts) {
    beginDialog(parts.context, "conflict", words::conflictTitle, false);
    ImGui::TextWrapped("%s", message_.c_str());
    bool const replace = choice(parts.context, words::replaceIt, "overwrite", Icon::Save, ButtonLook::Danger);
    bool const elsewhere = choice(parts.context, words::saveAsTitle, "save elsewhere", Icon::Save);
    bool const cancelled = choice(parts.context, words::cancel, "cancel conflict", Icon::Cross);
    parts.context.layout.endCard();
    if (replace) {
        close();
        actions::saveTo(parts, path_, edit::LevelDocument::Overwrite::yes);
    } else if (elsewhere) {
        close();
        actions::saveAs(parts);
    } else if (cancelled) {
        close();
        parts.giveUpLeaving();
    }
}

void Dialogs::draw(EditParts& parts) {
    if (parts.context.menuKeys.pressed(MenuKey::back)) {
        close();
        parts.giveUpLeaving();
        return;
    }
    switch (shown_) {
    case Shown::unsaved:
        return drawUnsaved(parts);
    case Shown::recovery:
        return drawRecovery(parts);
    case Shown::readOnly:
        return drawReadOnly(parts);
    case Shown::partName:
        return drawPartName(parts);
    case Shown::conflict:
        return drawConflict(parts);
    case Shown::none:
        break;
    }
}

} // namespace trembler::ui
