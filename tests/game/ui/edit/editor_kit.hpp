// A simulated designer: the player of the other tests, in the editor.
#pragma once

#include "game/ui/edit/edit_screen.hpp"
#include "tests/game/ui/player.hpp"

#include <fstream>
#include <sstream>

namespace trembler::ui::test {

inline std::string textOfFile(std::filesystem::path const& file) {
    std::ifstream in(file);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

class Designer : public Player {
public:
    explicit Designer(render::Size size = {1280, 720}, std::filesystem::path profile = {})
        : Player(size, std::move(profile)) {}

    /// A copy of a level in the test's own folder, opened.
    std::filesystem::path editCopyOf(std::filesystem::path const& level) {
        auto const copy = testFolder() / level.filename();
        std::filesystem::copy_file(level, copy, std::filesystem::copy_options::overwrite_existing);
        app().edit(copy);
        frames(4);
        return copy;
    }
    void editNew() {
        app().edit({});
        frames(4);
    }
    EditScreen& screen() { return dynamic_cast<EditScreen&>(app().screen()); }
    EditParts& parts() { return screen().parts(); }
    edit::Json const& tree() { return parts().tree(); }
    Point on(Vec2 world) { return parts().camera().toScreen({world.x, world.y}); }
    std::size_t count(char const* list) { return tree().contains(list) ? tree()[list].size() : 0; }
    Vec2 placeOf(std::string const& name) {
        for (auto const& object : tree()["objects"]) {
            if (object["name"] == name) {
                return {object["at"][0].get<double>(), object["at"][1].get<double>()};
            }
        }
        ADD_FAILURE() << "no object " << name;
        return {};
    }
    void select(Vec2 at) { click(on(at)); }
    /// A level with this text, in the test's own folder, opened.
    void editText(std::string const& level) {
        auto const file = testFolder() / "edited.json";
        std::ofstream(file) << level;
        app().edit(file);
        frames(4);
    }
    void doubleClick(Point at) {
        click(at);
        for (bool const down : {true, false}) {
            render::pushMouseButton(window(), MouseButton::Left, down, at, 2);
            frame();
        }
        frame();
    }
    /// Scrolls the panel from its top until the item is in sight.
    void seek(std::string const& item) {
        moveTo(layout().card("panel")->middle());
        for (int i = 0; i < 60; ++i) {
            wheel(1);
        }
        scrollTo("panel", item);
    }
    void ctrl(SDL_Keycode letter) { key(letter, KMOD_LCTRL); }
    void typeText(std::string const& text) {
        render::pushText(window(), text);
        frame();
    }
};

} // namespace trembler::ui::test
