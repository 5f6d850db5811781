// Whatever a level file may state, by the published schema, can be set in the editor: every widget of every
// page and every command is used once, and what changes in the file is compared with the schema. Properties
// of objects, joints and the world are described once for files and forms:
// tests/puzzle/edit/whole/schema_properties_test.cpp.
#include "puzzle/data/published_schema.hpp"
#include "tests/game/ui/edit/editor_kit.hpp"

#include <regex>
#include <set>

namespace trembler::ui::test {
namespace schema_forms_test {
namespace {

using edit::Json;
using Places = std::set<std::string>;

/// Every place of a file that the schema has, with "[]" for an entry of a list and "*" for any key.
class SchemaPlaces {
public:
    explicit SchemaPlaces(Json const& schema) : root_(schema) {}

    Places places;

    void add(Json const& schema, std::string const& path) {
        if (auto const reference = schema.find("$ref"); reference != schema.end()) {
            std::string const name = reference->get<std::string>().substr(8); // behind "#/$defs/"
            if (name == "condition") {
                return addConditions(path);
            }
            if (name == "properties" || name == "joint") {
                return; // described once for files and forms
            }
            if (name != "name" && name != "point" && name != "box" && name != "area") {
                return add(root_["$defs"][name], path);
            }
        }
        bool deeper = false;
        for (char const* const several : {"anyOf", "oneOf"}) {
            for (Json const& one : schema.value(several, Json::array())) {
                add(one, path);
                deeper = true;
            }
        }
        Json const members = schema.value("properties", Json::object());
        for (auto const& member : members.items()) {
            add(member.value(), path + "/" + member.key());
            deeper = true;
        }
        Json const patterns = schema.value("patternProperties", Json::object());
        for (auto const& member : patterns.items()) {
            add(member.value(), path + "/*");
            deeper = true;
        }
        if (schema.contains("additionalProperties") && schema["additionalProperties"].is_object()) {
            add(schema["additionalProperties"], path + "/*");
            deeper = true;
        }
        if (schema.contains("items") && !schema.contains("minItems")) { // a list, not a pair of names
            add(schema["items"], path + "/[]");
            deeper = true;
        }
        if (!deeper) {
            places.insert(path);
        }
    }

private:
    /// The kinds of conditions, and what any of them may state; not the conditions within conditions.
    void addConditions(std::string const& path) {
        for (Json const& one : root_["$defs"]["condition"]["oneOf"]) {
            for (auto const& member : one["properties"].items()) {
                places.insert(path + "/" + member.key());
            }
        }
    }

    Json const& root_;
};

/// The places of a value, and of all within it, in the same form.
void placesIn(Json const& value, std::string const& path, Places& places) {
    places.insert(path);
    if (value.is_object()) {
        for (auto const& member : value.items()) {
            placesIn(member.value(), path + "/" + member.key(), places);
        }
    } else if (value.is_array()) {
        for (Json const& entry : value) {
            placesIn(entry, path + "/[]", places);
        }
    }
}

void differences(Json const& before, Json const& now, std::string const& path, Places& places) {
    if (before == now) {
        return;
    }
    if (before.is_object() && now.is_object()) {
        for (auto const& member : now.items()) {
            differences(before.value(member.key(), Json()), member.value(), path + "/" + member.key(),
                        places);
        }
        for (auto const& member : before.items()) {
            if (!now.contains(member.key())) {
                placesIn(member.value(), path + "/" + member.key(), places);
            }
        }
        places.insert(path);
        return;
    }
    if (before.is_array() && now.is_array()) {
        for (std::size_t i = 0; i < std::max(before.size(), now.size()); ++i) {
            differences(i < before.size() ? before[i] : Json(), i < now.size() ? now[i] : Json(),
                        path + "/[]", places);
        }
        places.insert(path);
        return;
    }
    placesIn(now.is_null() ? before : now, path, places);
}

/// Uses every widget and every command once, and takes the change back.
class EveryWidget {
public:
    explicit EveryWidget(Designer& designer) : designer_(designer) {}

    Places places;

    void usePage(Tab tab) {
        designer_.parts().tab = tab;
        designer_.frames(2);
        std::vector<std::string> items;
        Places seen;
        auto const panel = designer_.layout().card("panel");
        ASSERT_TRUE(panel);
        for (Placed const& item : designer_.layout().items()) {
            // One of several alike: "hint 0" stands for every hint.
            bool const inside = item.rect.low.x >= panel->low.x && item.rect.low.y > panel->low.y + 60;
            bool const switches = item.name.starts_with("tree "); // to the other tree of goals
            if (inside && !switches && seen.insert(kindOf(item.name)).second) {
                items.push_back(item.name);
            }
        }
        for (std::string const& item : items) {
            if (!designer_.shows(
                    item)) { // a level that takes long to be read, as on a busy machine, is read later
                designer_.frames(pause);
            }
            if (designer_.shows(item)) {
                use(item);
            }
        }
    }

    void runEveryCommand() {
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

    /// Pictures after which the editor has read and checked the level, however long that takes.
    static constexpr int pause = 20;

private:
    static std::string kindOf(std::string name) {
        for (char& c : name) {
            c = c >= '0' && c <= '9' ? '#' : c;
        }
        return name;
    }

    /// Notes what has changed since start(), and undoes it.
    bool takeBack() {
        EditParts& parts = designer_.parts();
        if (parts.test != nullptr) {
            designer_.key(SDLK_ESCAPE);
        }
        for (int i = 0; i < 3 && parts.dialogOpen(); ++i) {
            designer_.key(SDLK_ESCAPE);
        }
        bool const changed = parts.document.done() > 0;
        if (changed) {
            Json const now = parts.tree();
            parts.document.goTo(0);
            differences(parts.tree(), now, "", places);
            designer_.frames(1);
        }
        parts.tool = Tool::select;
        return changed;
    }

    void leaveField() {
        auto const panel = designer_.layout().card("panel");
        designer_.click({panel->low.x + 40, panel->low.y + 50}); // the page's heading
    }

    void use(std::string const& item) {
        EntryKind const kind = designer_.parts().selection.kind();
        std::string const path = designer_.parts().selection.path();
        std::vector<std::string> const selected = designer_.parts().selected();
        Point const at = designer_.item(item);
        designer_.drag(at, at + Point{30, 0}, MouseButton::Left, 2);
        if (!takeBack() && designer_.shows(item)) {
            if (choicesOf(item).empty()) { // a list that can drop down has done so already
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

    /// The first choices of a list that has dropped down; there may be as many as there are parts.
    std::vector<std::string> choicesOf(std::string const& item) {
        std::vector<std::string> choices;
        for (Placed const& shown : designer_.layout().items()) {
            if (shown.name.starts_with(item + " = ") && choices.size() < 20) {
                choices.push_back(shown.name);
            }
        }
        return choices;
    }

    /// An open list gives each of its choices; a field takes a word.
    void chooseOrType(std::string const& item) {
        designer_.frames(2); // a list that drops down has its size then
        std::vector<std::string> const choices = choicesOf(item);
        for (std::string const& choice : choices) {
            if (!designer_.shows(choice)) { // closed by the choice before
                designer_.clickItem(item);
                designer_.frames(4);
            }
            if (!designer_.shows(choice)) { // it had been open, and was closed by that
                designer_.clickItem(item);
                designer_.frames(4);
            }
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

    Designer& designer_;
};

/// A level with one of everything.
char const* const oneOfEach =
    R"({"version": 2, "title": "Each", "text": "One of each.", "demonstration": true,
    "world": {"bounds": [-4, -0.5, 8, 4.5]},
    "objects": [
        {"name": "floor", "at": [0, -0.15], "properties": {"material": "stone", "fixed": true,
         "shape": [{"form": "box", "width": 7.6, "height": 0.3}]}},
        {"name": "left", "part": "wire end", "at": [-1, 1]}, {"name": "right", "part": "wire end", "at": [1, 1]},
        {"name": "ball", "part": "steel ball", "at": [2, 0.15]}],
    "connections": [{"between": ["left", "right"], "kind": "wire"}],
    "placing": [[-1, 0, 2, 2]],
    "toolbox": [{"part": "steel bar", "count": 2}, {"wire": 2}],
    "goals": {"touching": ["ball", "floor"], "id": "won"}, "task": {"moved": {"object": "ball", "by": 1}},
    "hints": ["Think."],
    "teaching": [{"place": "steel bar", "at": [0, 1]}, {"wire": ["left", "right"]}, {"run": true},
                 {"grab": "ball", "to": [1, 1]}, {"cut": ["left", "right"]}],
    "texts": {"de": {"title": "Jedes", "text": "Eins von jedem.", "hints": ["Denk."], "goals": {"won": "Fertig"}}},
    "solutions": [{"name": "all", "placements": [{"part": "steel bar", "at": [0, 1]}], "wires": [["left", "ball"]],
        "inputs": [{"frame": 3, "grab": "ball", "at": [2, 0.15]}, {"frame": 4, "move": [2, 1]},
                   {"frame": 5, "release": true}, {"frame": 6, "cut": ["left", "right"]},
                   {"frame": 7, "remove": "ball"}]}]})";

TEST(SchemaForms, SetWhateverALevelFileMayState) {
    Json const schema = publishedSchema();
    SchemaPlaces wanted(schema);
    wanted.add(schema, "");
    Designer designer({1280, 6000}); // every widget is in sight
    designer.editText(oneOfEach);
    designer.parts().dialogs.close();
    designer.frames(2);
    ASSERT_TRUE(designer.parts().problems.all().empty())
        << designer.parts().problems.all().front().diagnostic.message;
    EveryWidget every(designer);
    every.usePage(Tab::level);
    every.usePage(Tab::goals);
    designer.clickItem("goal "); // its fields
    every.usePage(Tab::goals);
    designer.clickItem("tree task");
    every.usePage(Tab::goals);
    designer.clickItem("goal ");
    every.usePage(Tab::goals);
    designer.parts().tab = Tab::solutions;
    designer.frames(2);
    every.usePage(Tab::solutions);
    designer.frames(EveryWidget::pause);
    designer.clickItem("solution 0 entries");
    every.usePage(Tab::solutions);
    every.runEveryCommand();
    designer.parts().selection.set({"ball"});
    every.usePage(Tab::properties);
    designer.parts().selection.choose(EntryKind::connection, "/connections/0");
    every.usePage(Tab::properties);
    // Of any key that the places of the schema have, one is enough.
    std::set<std::string> missing;
    for (std::string place : wanted.places) {
        // A condition may lie in a list of conditions.
        std::size_t const last = place.rfind('/');
        bool const ofGoal = place.starts_with("/goals/") || place.starts_with("/task/");
        std::string pattern = std::regex_replace(place, std::regex(R"([\[\]])"), "\\$&");
        pattern = std::regex_replace(pattern, std::regex(R"(\*)"), "[^/]+");
        std::regex const like(pattern);
        bool const found = std::any_of(every.places.begin(), every.places.end(), [&](std::string const& had) {
            return ofGoal ? had.starts_with(place.substr(0, last + 1)) && had.ends_with(place.substr(last))
                          : std::regex_match(had, like);
        });
        if (!found) {
            missing.insert(place);
        }
    }
    // Written by the editor itself: the format's version, and which schema the author's text editor uses.
    EXPECT_EQ(missing.erase("/version") + missing.erase("/$schema"), 2U);
    for (auto const& property : schema["properties"]["world"]["properties"].items()) {
        std::string const place = "/world/" + property.key();
        if (property.key() != "bounds" && property.key() != "detail") { // described once for files and forms
            std::erase_if(missing, [&](std::string const& one) { return one.starts_with(place); });
        }
    }
    // Their forms are made from the schema: tests/puzzle/edit/inspect/solution_forms_test.cpp.
    for (edit::EntryList const& list : edit::solutionLists(schema)) {
        std::string const place = "/solutions/[]/" + list.key + "/";
        std::erase_if(missing, [&](std::string const& one) { return one.starts_with(place); });
    }
    for (std::string const& place : missing) {
        ADD_FAILURE() << place << " cannot be set in the editor";
    }
    EXPECT_GT(wanted.places.size(), 100U);
}

} // namespace
} // namespace schema_forms_test
} // namespace trembler::ui::test
