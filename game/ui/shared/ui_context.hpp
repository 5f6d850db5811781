// The objects that every screen of the program uses.
#pragma once

#include "game/budget/budget_mode.hpp"
#include "game/ui/shared/catalog/kind_finder.hpp"
#include "game/ui/shared/catalog/level_catalog.hpp"
#include "game/ui/shared/catalog/level_pictures.hpp"
#include "game/ui/shared/catalog/part_catalog.hpp"
#include "game/ui/shared/commands/key_bindings.hpp"
#include "game/ui/shared/commands/menu_keys.hpp"
#include "game/ui/shared/focus.hpp"
#include "game/ui/shared/kept/pending_writes.hpp"
#include "game/ui/shared/kept/profile.hpp"
#include "game/ui/shared/kept/recorder.hpp"
#include "game/ui/shared/kept/saved_solutions.hpp"
#include "game/ui/shared/layout.hpp"
#include "game/ui/shared/letters/screen_keyboard.hpp"
#include "puzzle/campaign/kept_builds.hpp"
#include "render/panels/gui.hpp"
#include "render/panels/toasts.hpp"
#include "render/window/input_events.hpp"

#include <filesystem>

namespace trembler {
class Loudspeaker;
}

namespace trembler::ui {

/// Objects that live as long as the program; GameApp owns them. Window thread only.
struct UiContext {
    render::Window& window;
    Registry const& registry;
    PartLibrary const& parts;
    render::Gui gui;
    render::Gamepads pads;
    render::InputEvents input;
    render::Canvas canvas;
    render::Toasts toasts;
    Layout layout;
    Focus focus;
    PartCatalog catalog;
    LevelCatalog levels;
    LevelPictures pictures;
    Profile profile;
    KeptBuilds builds;
    KindFinder kinds;
    KeyBindings keys;
    MenuKeys menuKeys{}; ///< of this picture, for pages, lists and dialogs
    WidgetKeys widgetKeys{};
    PendingWrites pending;
    Recorder recorder;
    SavedSolutions solutions;
    ScreenKeyboard letters{};
    Loudspeaker* loudspeaker = nullptr;        ///< nullptr: no sound
    budget::BudgetMode::Stopwatch stopwatch{}; ///< of time budgets; empty: the computer's clock
    std::filesystem::path edited{};            ///< folder of the level that the editor saved last
    bool shadows = true; ///< soft shadows, if the settings and the graphics driver allow them

    [[nodiscard]] bool shiftHeld() const { return (input.modifiers() & KMOD_SHIFT) != 0; }
    [[nodiscard]] bool controlHeld() const { return (input.modifiers() & KMOD_CTRL) != 0; }
    [[nodiscard]] bool altHeld() const { return (input.modifiers() & KMOD_ALT) != 0; }
};

} // namespace trembler::ui
