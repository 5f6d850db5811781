#include "tests/game/ui/screen_walk.hpp"

#include "game/ui/app/title/title_screen.hpp"
#include "game/ui/edit/edit_screen.hpp"
#include "game/ui/edit/study/level_studies.hpp"
#include "render/window/gamepad.hpp"
#include "runtime/placement.hpp"

#include <array>
#include <utility>

namespace trembler::ui::test {
namespace {

/// Frames after which cards know their size and fading tips have disappeared.
constexpr int settled = 8;

auto const walkedLevel = levelsFolder() / "first/1-first-contact.json";

void lookAtMenu(Player& player, MenuPage page, std::string const& name, Look const& look) {
    player.app().show(std::make_unique<TitleScreen>(player.app().context()));
    player.frames(2);
    player.app().openMenu(page);
    player.frames(settled);
    look(name);
    player.key(SDLK_ESCAPE);
}

/// Moves the pointer to a place where it shows no tip and touches nothing.
void restPointer(Player& player) {
    render::Size const size = window().size();
    player.moveTo({0.5 * size.width, size.height - 2.0});
    player.frames(settled);
}

/// Shows a what-if in which a ball is elsewhere at a moment of a run.
void lookAtWhatIf(Player& player, Look const& look) {
    player.open(walkedLevel);
    player.drag(player.item("part steel bar"), player.at({-1.8, 1.3}));
    player.key(SDLK_SPACE);
    player.simulate(80);
    player.key(SDLK_p);
    player.key(SDLK_k);
    for (int i = 0; i < 6; ++i) {
        player.key(SDLK_PAGEUP, KMOD_LSHIFT);
    }
    player.key(SDLK_z);
    player.frames(settled);
    player.key(SDLK_HOME); // the timeline lies over the floor
    player.frames(2);
    World const& past = player.play().timeline().world();
    Vec2 const ball = past.find<Position>(past.store().find("iron ball"))->value;
    player.drag(player.at(ball), player.at(ball + Vec2{0.7, 0.3}));
    player.frames(settled);
    player.key(SDLK_PAGEDOWN, KMOD_LSHIFT);
    player.key(SDLK_PAGEDOWN, KMOD_LSHIFT);
    restPointer(player);
    look("level-what-if");
}

void openEditor(Player& player) {
    auto const copy = testFolder() / walkedLevel.filename();
    std::filesystem::copy_file(walkedLevel, copy, std::filesystem::copy_options::overwrite_existing);
    player.app().edit(copy);
    player.frames(4);
}

/// Shows the report on the level, and the search for further solutions, of few runs.
void lookAtStudies(Player& player, Look const& look) {
    LevelStudies& studies = *dynamic_cast<EditScreen&>(player.app().screen()).parts().studies;
    studies.reportOptions.robustness.runs = 8;
    studies.reportOptions.drops = 8;
    studies.reportOptions.map.places = 48;
    studies.request.runs = 40;
    player.key(SDLK_e, KMOD_LCTRL);
    studies.report().work->wait();
    player.frames(settled);
    player.scrollTo("panel", "reported 0");
    player.clickItem("reported 0");
    restPointer(player);
    look("edit-report");
    player.key(SDLK_f, KMOD_LCTRL);
    studies.searched().work->wait();
    restPointer(player);
    look("edit-search");
}

/// Asks about the goal, and shows the first step of the answer.
void askWhy(Player& player) {
    player.key(SDLK_y, KMOD_LSHIFT);
    player.play().why().wait();
    player.frames(2);
    player.key(SDLK_d);
    restPointer(player);
}

void walkEditorPages(Player& player, Look const& look, bool studies) {
    openEditor(player);
    auto const press = [&](SDL_Keycode key) {
        player.key(key);
        restPointer(player);
    };
    press(SDLK_F2);
    look("edit-parts");
    press(SDLK_F3);
    look("edit-outline");
    player.clickItem("object beam");
    press(SDLK_F4);
    look("edit-properties");
    press(SDLK_F5);
    player.clickItem("goal /all/1");
    restPointer(player);
    look("edit-goals");
    press(SDLK_F6);
    look("edit-level");
    player.key(SDLK_F9);
    player.frames(2);
    player.key(SDLK_DOWN);
    player.key(render::padKey(SDL_CONTROLLER_BUTTON_A)); // types the title by a gamepad
    player.frames(settled);
    look("edit-letters");
    player.key(render::padKey(SDL_CONTROLLER_BUTTON_B));
    player.frames(2);
    player.key(SDLK_ESCAPE);
    press(SDLK_F7);
    look("edit-solutions");
    if (studies) {
        lookAtStudies(player, look);
    }
    press(SDLK_F8);
    look("edit-problems");
    player.key(SDLK_p, KMOD_LCTRL);
    player.frames(settled);
    look("edit-commands");
    player.key(SDLK_ESCAPE);
    player.frames(2);
    press(SDLK_SPACE);
    look("edit-test");
    player.key(SDLK_ESCAPE);
    player.frames(4);
}

} // namespace

void walkMenus(Player& player, Look const& look) {
    player.app().showTitle();
    restPointer(player);
    look("title");
    for (auto const& [page, name] :
         {std::pair{MenuPage::levels, "levels"}, std::pair{MenuPage::gallery, "gallery"},
          std::pair{MenuPage::settings, "settings"}, std::pair{MenuPage::keys, "keys"},
          std::pair{MenuPage::help, "help"}, std::pair{MenuPage::ending, "ending"}}) {
        lookAtMenu(player, page, name, look);
    }
}

void walkLevel(Player& player, Look const& look) {
    player.open(walkedLevel);
    restPointer(player);
    look("level");
    player.moveTo(player.item("part steel bar"));
    player.press();
    player.moveTo(player.at({1.7, 1.8}));
    player.frames(2);
    look("level-refused");
    player.moveTo(player.at({-1.8, 1.3}));
    player.release();
    for (int hint = 0; hint < 3; ++hint) {
        player.key(SDLK_h);
    }
    restPointer(player);
    look("level-placed");
    player.key(SDLK_n);
    player.click(player.at({1.7, 1.7}));
    restPointer(player);
    look("level-inspector");
    player.key(SDLK_ESCAPE);
    player.key(SDLK_n);
    player.key(SDLK_SPACE);
    player.simulate(40);
    player.frames(2);
    look("level-running");
    player.key(SDLK_ESCAPE);
    player.frames(settled);
    look("level-menu");
    player.clickItem("menu.commands");
    restPointer(player);
    look("level-commands");
    player.key(SDLK_ESCAPE);
    player.frames(2);
    player.key(SDLK_ESCAPE);
    player.simulate(400);
    ASSERT_TRUE(player.session().solved());
    player.frames(60); // the seal has come to rest
    look("level-solved");
    askWhy(player);
    look("level-why");
}

void walkOthers(Player& player, Look const& look) {
    player.open(levelsFolder() / "experiments/1-switched-electromagnet.json");
    player.key(SDLK_SPACE);
    player.simulate(64);
    for (SDL_Keycode const overlay : {SDLK_1, SDLK_2, SDLK_3, SDLK_n}) {
        player.key(overlay);
    }
    player.key(SDLK_p);
    restPointer(player);
    look("experiment-paused");
    player.key(SDLK_p);
    player.simulate(64);
    player.key(SDLK_p);
    player.key(SDLK_n);
    player.key(SDLK_c);
    restPointer(player);
    look("components");
    // A mod of the program: for others the panel shows their folder, which is another one in each clone.
    player.open(levelsFolder().parent_path() / "mods/pressure-plate/levels/1-four-knocks.json");
    player.key(SDLK_m);
    player.frames(4);
    restPointer(player);
    look("mods");
    player.open(walkedLevel);
    player.key(SDLK_c);
    restPointer(player);
    look("components-building");
    player.open(levelsFolder() / "2-electricity/1-both-gaps.json");
    restPointer(player);
    look("level-wires");
    player.key(SDLK_SPACE);
    player.simulate(40);
    player.key(SDLK_p);
    askWhy(player);
    look("level-why-not");
    player.open(levelsFolder() / "5-everything/2-the-gate.json");
    restPointer(player);
    look("level-gate");
    player.app().showTitle();
    player.frames(3);
    player.clickItem("free play");
    restPointer(player);
    look("free-play");
    lookAtWhatIf(player, look);
}

void walkEditor(Player& player, Look const& look) {
    walkEditorPages(player, look, true);
}
void walkEditorWithoutStudies(Player& player, Look const& look) {
    walkEditorPages(player, look, false);
}

void walkStudies(Player& player, Look const& look) {
    openEditor(player);
    lookAtStudies(player, look);
}

} // namespace trembler::ui::test
