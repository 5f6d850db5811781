// Whatever a level file may state, by the published schema, can be set in the editor: every widget of every
// page and every command is used once, and what changes in the file is compared with the schema. Properties
// of objects, joints and the world are described once for files and forms:
// tests/puzzle/edit/whole/schema_properties_test.cpp.
#include "puzzle/data/published_schema.hpp"
#include "tests/game/ui/edit/whole/every_widget.hpp"

#include <algorithm>
#include <regex>
#include <string>

namespace trembler::ui::test {
namespace schema_forms_test {
namespace {

using edit::Json;

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

/// The pages and commands by which a place of a file is set. Each has a test, and each place of the schema is
/// looked for in one of them.
enum class By { level, goals, solutions, scene };

By settingOf(std::string const& place) {
    if (place.starts_with("/goals") || place.starts_with("/task")) {
        return By::goals;
    }
    if (place.starts_with("/solutions")) {
        return By::solutions;
    }
    for (char const* const list : {"/objects", "/joints", "/connections", "/placing", "/editor"}) {
        if (place.starts_with(list)) {
            return By::scene;
        }
    }
    return By::level;
}

class SchemaForms : public testing::Test {
protected:
    SchemaForms() {
        designer.editText(oneOfEach);
        designer.parts().dialogs.close();
        designer.frames(2);
        EXPECT_TRUE(designer.parts().problems.all().empty());
    }
    /// Of any key that the places of the schema have, one is enough.
    [[nodiscard]] bool wasSet(std::string const& place) const {
        // A condition may lie in a list of conditions.
        std::size_t const last = place.rfind('/');
        bool const ofGoal = place.starts_with("/goals/") || place.starts_with("/task/");
        std::string pattern = std::regex_replace(place, std::regex(R"([\[\]])"), "\\$&");
        pattern = std::regex_replace(pattern, std::regex(R"(\*)"), "[^/]+");
        std::regex const like(pattern);
        return std::any_of(every.places.begin(), every.places.end(), [&](std::string const& had) {
            return ofGoal ? had.starts_with(place.substr(0, last + 1)) && had.ends_with(place.substr(last))
                          : std::regex_match(had, like);
        });
    }
    void expectAllSet(By by, std::size_t least) const {
        Json const schema = publishedSchema();
        std::size_t wanted = 0;
        for (std::string const& place : placesOf(schema)) {
            if (settingOf(place) == by && isOfThePages(schema, place)) {
                ++wanted;
                EXPECT_TRUE(wasSet(place)) << place << " cannot be set in the editor";
            }
        }
        EXPECT_GE(wanted, least);
    }

    Designer designer{{1280, 6000}}; // every widget is in sight
    EveryWidget every{designer};

private:
    static bool isOfThePages(Json const& schema, std::string const& place) {
        // Written by the editor itself: the format's version, and which schema the author's text editor uses.
        if (place == "/version" || place == "/$schema") {
            return false;
        }
        // Described once for files and forms.
        for (auto const& property : schema["properties"]["world"]["properties"].items()) {
            bool const here = property.key() == "bounds" || property.key() == "detail";
            if (!here && place.starts_with("/world/" + property.key())) {
                return false;
            }
        }
        // Their forms are made from the schema: tests/puzzle/edit/inspect/solution_forms_test.cpp.
        auto const lists = edit::solutionLists(schema);
        return std::none_of(lists.begin(), lists.end(), [&](edit::EntryList const& list) {
            return place.starts_with("/solutions/[]/" + list.key + "/");
        });
    }
};

TEST_F(SchemaForms, OfTheLevelSetWhateverAFileMayState) {
    every.usePage(Tab::level);
    expectAllSet(By::level, 29);
}

TEST_F(SchemaForms, OfGoalsSetWhateverAFileMayState) {
    every.usePage(Tab::goals);
    designer.clickItem("goal "); // its fields
    every.usePage(Tab::goals);
    designer.clickItem("tree task");
    every.usePage(Tab::goals);
    designer.clickItem("goal ");
    every.usePage(Tab::goals);
    expectAllSet(By::goals, 26);
}

TEST_F(SchemaForms, OfSolutionsSetWhateverAFileMayState) {
    designer.parts().tab = Tab::solutions;
    designer.frames(2);
    every.usePage(Tab::solutions);
    designer.frames(EveryWidget::pause);
    designer.clickItem("solution 0 entries");
    every.usePage(Tab::solutions);
    expectAllSet(By::solutions, 3);
}

TEST_F(SchemaForms, OfObjectsAndCommandsSetWhateverAFileMayState) {
    every.runEveryCommand();
    designer.parts().selection.set({"ball"});
    every.usePage(Tab::properties);
    designer.parts().selection.choose(EntryKind::connection, "/connections/0");
    every.usePage(Tab::properties);
    expectAllSet(By::scene, 5);
}

TEST(SchemaPlaces, AreMoreThanAHundred) {
    EXPECT_GT(placesOf(publishedSchema()).size(), 100U);
}

} // namespace
} // namespace schema_forms_test
} // namespace trembler::ui::test
