#include "tests/game/ui/edit/whole/every_widget.hpp"

#include <imgui_internal.h>

namespace trembler::ui::test {
namespace every_widget {
namespace {

/// One of several alike: "hint #" stands for every hint.
std::string kindOf(std::string name) {
    for (char& c : name) {
        c = c >= '0' && c <= '9' ? '#' : c;
    }
    return name;
}

} // namespace
} // namespace every_widget

void EveryWidget::usePage(Tab tab) {
    designer_.parts().tab = tab;
    designer_.frames(2);
    std::vector<std::string> items;
    std::string const page =
        std::to_string(static_cast<int>(tab)) + std::to_string(static_cast<int>(designer_.parts().goalTree));
    auto const panel = designer_.layout().card("panel");
    ASSERT_TRUE(panel);
    for (Placed const& item : designer_.layout().items()) {
        bool const inside = item.rect.low.x >= panel->low.x && item.rect.low.y > panel->low.y + 60;
        bool const switches = item.name.starts_with("tree "); // to the other tree of goals
        if (inside && !switches && used_.insert(page + every_widget::kindOf(item.name)).second) {
            items.push_back(item.name);
        }
    }
    for (std::string const& item : items) {
        if (!designer_.shows(item)) {
            // A level that takes long to be read, as on a busy machine, is read later.
            designer_.frames(pause);
        }
        if (designer_.shows(item)) {
            use(item);
        }
    }
}

void EveryWidget::runEveryCommand() {
    CommandSet& commands = designer_.screen().commands();
    for (std::size_t i = 0; i < commands.size(); ++i) {
        std::string_view const id = commands.info(i).id;
        designer_.parts().selection.set({"ball", "left"});
        if (!commands.available(i) || commands.info(i).leads || id == "edit-new" || id == "edit-open" ||
            id == "fullscreen" || id == "edit-menu" || id == "edit-undo" || id == "edit-redo" ||
            id == "edit-make-report" || id == "edit-find-solutions") {
            continue;
        }
        commands.run(i);
        designer_.frames(1);
        if (designer_.parts().tool != Tool::select) { // the second time makes something
            commands.run(i);
            designer_.frames(1);
        }
        takeBack();
    }
}

bool EveryWidget::takeBack() {
    EditParts& parts = designer_.parts();
    if (parts.test != nullptr) {
        designer_.key(SDLK_ESCAPE);
    }
    for (int i = 0; i < 3 && parts.dialogOpen(); ++i) {
        designer_.key(SDLK_ESCAPE);
    }
    bool const changed = parts.document.done() > 0;
    if (changed) {
        edit::Json const now = parts.tree();
        parts.document.goTo(0);
        places.merge(differences(parts.tree(), now));
        designer_.frames(1);
    }
    parts.tool = Tool::select;
    return changed;
}

void EveryWidget::leaveField() {
    auto const panel = designer_.layout().card("panel");
    designer_.click({panel->low.x + 40, panel->low.y + 50}); // the page's heading
}

void EveryWidget::use(std::string const& item) {
    EntryKind const kind = designer_.parts().selection.kind();
    std::string const path = designer_.parts().selection.path();
    std::vector<std::string> const selected = designer_.parts().selected();
    Point const at = designer_.item(item);
    designer_.drag(at, at + Point{30, 0}, MouseButton::Left, 2);
    if (!takeBack() && designer_.shows(item)) {
        // A list that can drop down has done so already.
        if (choicesOf(item).empty() && !designer_.parts().dropDown.open()) {
            designer_.click(designer_.item(item));
            designer_.frames(1);
        }
        chooseOrType(item);
        takeBack();
    }
    if (kind == EntryKind::none) {
        designer_.parts().selection.set(selected);
    } else {
        designer_.parts().selection.choose(kind, path);
    }
    designer_.frames(1);
}

std::vector<std::string> EveryWidget::choicesOf(std::string const& item) {
    // What is added differs with the kind of goal, step or input; one object or part is as good as another.
    bool const kinds = item == "add goal" || item == "add step" || item == "add inputs";
    std::size_t const most = kinds ? 20 : 3;
    std::vector<std::string> choices;
    for (Placed const& shown : designer_.layout().items()) {
        if (shown.name.starts_with(item + " = ") && choices.size() < most) {
            choices.push_back(shown.name);
        }
    }
    return choices;
}

void EveryWidget::chooseOrType(std::string const& item) {
    designer_.frames(2);     // a list that drops down has its size then
    auto const toTop = [&] { // a long list shows its present entry first
        if (designer_.parts().dropDown.open()) {
            designer_.key(SDLK_HOME);
            designer_.frames(1);
        }
    };
    toTop();
    std::vector<std::string> const choices = choicesOf(item);
    for (std::string const& choice : choices) {
        if (!designer_.shows(choice)) { // closed by the choice before
            designer_.clickItem(item);
            designer_.frames(4);
        }
        if (!designer_.shows(choice) && !designer_.parts().dropDown.open()) { // closed by that
            designer_.clickItem(item);
            designer_.frames(4);
        }
        toTop();
        if (designer_.shows(choice)) {
            designer_.clickItem(choice);
            takeBack();
        }
    }
    if (choices.empty() && designer_.app().context().gui.wantsKeyboard()) {
        designer_.ctrl(SDLK_a);
        designer_.typeText("q");
        leaveField();
    }
    ImGui::ClosePopupsOverWindow(nullptr, false);
}

} // namespace trembler::ui::test
