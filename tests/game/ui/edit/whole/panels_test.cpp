// The editor's panel and commands: every page, every command, every size of the window.
#include "game/ui/edit/commands/edit_commands.hpp"
#include "game/ui/edit/panels/command_palette.hpp"
#include "tests/game/ui/edit/editor_kit.hpp"

namespace trembler::ui::test {
namespace panels_test {
namespace {

auto const firstContact = levelsFolder() / "first/1-first-contact.json";

void expectNoOverlap(Layout const& layout, std::string const& where) {
    auto const& cards = layout.cards();
    for (std::size_t i = 0; i < cards.size(); ++i) {
        for (std::size_t j = i + 1; j < cards.size(); ++j) {
            EXPECT_FALSE(cards[i].rect.overlaps(cards[j].rect))
                << cards[i].name << " overlaps " << cards[j].name << " " << where;
        }
    }
}

TEST(EditorPanels, NothingOverlapsAtAnySize) {
    for (render::Size const size : {render::Size{800, 600}, render::Size{1280, 720}, render::Size{1024, 768},
                                    render::Size{2560, 1440}}) {
        Designer designer(size);
        designer.editCopyOf(firstContact);
        for (SDL_Keycode const page : {SDLK_F2, SDLK_F3, SDLK_F4, SDLK_F5, SDLK_F6, SDLK_F7, SDLK_F8}) {
            designer.key(page);
            designer.frames(2);
            expectNoOverlap(designer.layout(),
                            std::to_string(size.width) + " page " + std::to_string(page - SDLK_F2 + 2));
            if (size.width == 800) {
                designer.look("edit-narrow-" + std::to_string(page - SDLK_F2 + 2));
            }
        }
        designer.look("edit-size-" + std::to_string(size.width));
    }
}

TEST(EditorPanels, PagesShowTheLevel) {
    Designer designer;
    designer.editCopyOf(firstContact);
    designer.key(SDLK_F2);
    designer.look("edit-page-parts");
    designer.key(SDLK_F3);
    designer.frames(2);
    designer.clickItem("object beam");
    EXPECT_EQ(designer.parts().selected(), std::vector<std::string>{"beam"});
    designer.look("edit-page-outline");
    designer.key(SDLK_F4);
    designer.frames(2);
    designer.look("edit-page-properties");
    designer.key(SDLK_F5);
    designer.frames(2);
    designer.clickItem("goal /all/1");
    designer.frames(2);
    designer.look("edit-page-goals");
    designer.key(SDLK_F6);
    designer.frames(2);
    designer.look("edit-page-level");
    designer.key(SDLK_F7);
    designer.frames(2);
    designer.look("edit-page-solutions");
}

TEST(EditorPanels, TheInspectorChangesAPropertyByDragging) {
    Designer designer;
    designer.editCopyOf(firstContact);
    designer.select({1.7, 0.15});
    designer.key(SDLK_F4);
    designer.frames(2);
    Point const field = designer.item("at x");
    std::size_t const steps = designer.parts().document.done();
    designer.drag(field, field + Point{60, 0});
    EXPECT_NE(designer.placeOf("iron ball").x, 1.7);
    EXPECT_EQ(designer.parts().document.done(), steps + 1) << "one use of a widget is one step";
    EXPECT_EQ(designer.parts().selected().size(), 1U);
}

// 7.1.1: a script is attached to an object by a drop-down, and its parameters have widgets of their own.
TEST(EditorPanels, TheInspectorAttachesAScriptAndSetsItsParameters) {
    Designer designer;
    designer.editCopyOf(std::filesystem::path(TREMBLER_SOURCE_DIR) / "mods/wind/levels/1-a-fair-wind.json");
    designer.select({-1.5, 0.3});
    ASSERT_EQ(designer.parts().selected(), std::vector<std::string>{"sledge"});
    designer.key(SDLK_F4);
    designer.frames(2);
    designer.scrollTo("panel", "add script");
    designer.clickItem("add script");
    designer.frames(2);
    designer.clickItem("add script = Dynamics <- Wind");
    designer.frames(2);
    auto const uses = [&] {
        for (auto const& object : designer.tree()["objects"]) {
            if (object["name"] == "sledge") {
                return object["properties"].value("scripts", edit::Json::array());
            }
        }
        return edit::Json();
    };
    ASSERT_EQ(uses().size(), 1U);
    EXPECT_EQ(uses()[0]["script"], "Dynamics <- Wind");
    designer.scrollTo("panel", "speed of Dynamics <- Wind");
    Point const slider = designer.item("speed of Dynamics <- Wind");
    designer.drag(slider, slider + Point{40, 0});
    ASSERT_EQ(uses()[0]["set"].size(), 1U);
    EXPECT_EQ(uses()[0]["set"][0]["param"], "speed");
    EXPECT_GT(uses()[0]["set"][0]["number"].get<double>(), 8);
    EXPECT_LE(uses()[0]["set"][0]["number"].get<double>(), 100) << "the range that the script states";
    designer.look("edit-scripts");
    designer.clickItem("remove script Dynamics <- Wind");
    designer.frames(2);
    EXPECT_TRUE(uses().empty());
}

/// Scrolls the panel until the item is in sight.
void seek(Designer& designer, std::string const& item) {
    designer.moveTo(designer.layout().card("panel")->middle());
    for (int i = 0; i < 60; ++i) {
        designer.wheel(1);
    }
    designer.scrollTo("panel", item);
}

TEST(EditorPanels, TeachingStepsAreAddedChangedAndUndone) {
    Designer designer;
    designer.editCopyOf(firstContact);
    edit::Json const before = designer.tree();
    ASSERT_EQ(designer.count("teaching"), 2U);
    designer.key(SDLK_F6);
    designer.frames(3);
    seek(designer, "add step");
    designer.clickItem("add step");
    designer.frames(2);
    designer.clickItem("add step = cut");
    designer.frames(3);
    ASSERT_EQ(designer.count("teaching"), 3U);
    EXPECT_TRUE(designer.tree()["teaching"][2].contains("cut"));
    seek(designer, "step 2 up");
    designer.clickItem("step 2 up");
    designer.frames(3);
    EXPECT_TRUE(designer.tree()["teaching"][1].contains("cut"));
    seek(designer, "step 0 at x");
    designer.drag(designer.item("step 0 at x"), designer.item("step 0 at x") + Point{40, 0});
    EXPECT_NE(designer.tree()["teaching"][0]["at"], before["teaching"][0]["at"]);
    designer.look("edit-teaching");
    for (int i = 0; i < 3; ++i) {
        designer.ctrl(SDLK_z);
        designer.frames(1);
    }
    EXPECT_EQ(designer.tree(), before);
}

TEST(EditorPanels, WiresAreNoPartOfTheToolbox) {
    Designer designer;
    designer.editCopyOf(levelsFolder() / "5-everything/2-the-gate.json");
    designer.key(SDLK_F6);
    designer.frames(3);
    auto const wires = [&] {
        for (auto const& tool : designer.tree()["toolbox"]) {
            if (tool.contains("wire")) {
                return tool["wire"].get<int>();
            }
        }
        return 0;
    };
    int const before = wires();
    ASSERT_GT(before, 0);
    seek(designer, "wires");
    designer.drag(designer.item("wires"), designer.item("wires") + Point{80, 0});
    EXPECT_GT(wires(), before);
    for (auto const& tool : designer.tree()["toolbox"]) {
        EXPECT_FALSE(tool.contains("wire") && tool.contains("count"));
    }
}

TEST(EditorPanels, ADeletedObjectIsAProblemWhoseClickLeadsToTheGoal) {
    Designer designer;
    designer.editCopyOf(firstContact);
    designer.select({1.7, 0.15});
    designer.key(SDLK_DELETE);
    designer.frames(40);
    ASSERT_FALSE(designer.parts().problems.empty());
    designer.key(SDLK_F8);
    designer.frames(2);
    designer.look("edit-problems");
    designer.clickItem("problem 0");
    EXPECT_EQ(designer.parts().tab, Tab::goals);
}

TEST(EditorPanels, EveryCommandRunsByItsKeyAndUndoBringsTheFileBack) {
    Designer designer;
    designer.editCopyOf(firstContact);
    std::string const before = designer.parts().document.text();
    // After a change, a new level is begun only after a question.
    designer.parts().selection.set({"iron ball"});
    designer.key(SDLK_LEFT);
    for (Command<EditParts> const& command : editCommands()) {
        if (command.info.keys[0].key == SDLK_UNKNOWN || command.info.leads ||
            command.info.id == "fullscreen") {
            continue;
        }
        SCOPED_TRACE(std::string(command.info.id));
        designer.parts().selection.set({"iron ball", "left post", "right post"});
        Chord const& chord = command.info.keys[0];
        unsigned modifiers = KMOD_NONE;
        modifiers |= chord.ctrl ? unsigned{KMOD_LCTRL} : 0U;
        modifiers |= chord.shift ? unsigned{KMOD_LSHIFT} : 0U;
        modifiers |= chord.alt ? unsigned{KMOD_LALT} : 0U;
        designer.key(chord.key, modifiers);
        designer.frames(2);
        for (int i = 0; i < 3 && (designer.parts().dialogOpen() || designer.parts().panelKeys ||
                                  designer.screen().test() != nullptr || designer.app().menu().isOpen());
             ++i) {
            designer.key(SDLK_ESCAPE);
            designer.frames(1);
        }
        ASSERT_FALSE(designer.parts().dialogOpen());
    }
    designer.parts().document.goTo(0);
    EXPECT_EQ(designer.parts().document.text(), before);
}

TEST(EditorPanels, ThePaletteFindsCommandsByWords) {
    EXPECT_TRUE(fitsSearch("Align left edges", "left ali"));
    EXPECT_FALSE(fitsSearch("Align left edges", "right"));
    Designer designer;
    designer.editCopyOf(firstContact);
    designer.ctrl(SDLK_p);
    designer.frames(2);
    designer.typeText("solutions");
    designer.frames(1);
    designer.look("edit-palette");
    designer.key(SDLK_RETURN);
    EXPECT_EQ(designer.parts().tab, Tab::solutions);
}

TEST(EditorPanels, AFileWithErrorsOpensReadOnlyWithTheListOfThem) {
    Designer designer;
    auto const file = testFolder() / "wrong.json";
    std::ofstream(file) << R"({"version": 2, "title": "Wrong", "objects": [{"name": "a", "part": 3}]})";
    designer.app().edit(file);
    designer.frames(4);
    EXPECT_TRUE(designer.parts().document.readOnly());
    EXPECT_TRUE(designer.showsCard("read only"));
    designer.look("edit-read-only");
    designer.clickItem("understood");
    designer.frames(2);
    EXPECT_FALSE(designer.showsCard("read only"));
}

TEST(EditorPanels, TheBrowserOpensAndSaves) {
    Designer designer;
    auto const file = designer.editCopyOf(firstContact);
    designer.key(SDLK_s, KMOD_LCTRL | KMOD_LSHIFT);
    designer.frames(2);
    EXPECT_TRUE(designer.showsCard("file browser"));
    designer.look("edit-browser");
    std::filesystem::remove(file);
    designer.clickItem("choose file");
    designer.frames(2);
    EXPECT_TRUE(std::filesystem::exists(file));
}

} // namespace
} // namespace panels_test
} // namespace trembler::ui::test
