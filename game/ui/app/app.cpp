#include "game/ui/app/app.hpp"

#include "render/draw/palette.hpp"
#include "runtime/level/json/diagnostic.hpp"

namespace trembler::ui {

GameApp::GameApp(render::Window& window, Registry const& registry, PartLibrary const& parts,
                 GameOptions const& options)
    : options_(options), desk_{.window = window,
                               .registry = registry,
                               .parts = parts,
                               .gui = render::Gui(window, {.steady = options.steady}),
                               .input = render::InputEvents(window),
                               .canvas = {},
                               .toasts = {},
                               .layout = {},
                               .shelf = PartShelf(parts, desk_.canvas),
                               .levels = LevelShelf(registry, options.levels),
                               .profile = Profile(options.profile),
                               .recorder = Recorder(options.pictures),
                               .loudspeaker = options.loudspeaker},
      title_(desk_) {
    applySettings(desk_);
}

GameApp::~GameApp() = default;

void GameApp::open(std::filesystem::path const& level) {
    play_ = std::make_unique<PlayScreen>(desk_, level, options_.world);
    menu_.close();
}

void GameApp::tryOpen(ShelfEntry const& entry) {
    try {
        open(entry.file);
    } catch (InputError const& error) {
        desk_.toasts.add(error.what(), render::ToastKind::Trouble, 10);
    }
}

void GameApp::toggleFullscreen() {
    Settings settings = desk_.profile.settings();
    settings.fullscreen = !settings.fullscreen;
    bool const shadows = desk_.shadows;
    desk_.profile.setSettings(settings);
    applySettings(desk_);
    desk_.shadows = shadows;
}

void GameApp::follow(PlayWish wish) {
    switch (wish) {
    case PlayWish::none:
        break;
    case PlayWish::menu:
        menu_.open(MenuPage::main);
        break;
    case PlayWish::levels:
        menu_.open(MenuPage::levels);
        break;
    case PlayWish::help:
        menu_.open(MenuPage::help);
        break;
    case PlayWish::fullscreen:
        toggleFullscreen();
        break;
    case PlayWish::nextLevel:
        if (ShelfEntry const* const next = desk_.levels.after(play_->file())) {
            tryOpen(*next);
        }
        break;
    }
}

void GameApp::updateMenu() {
    auto const& input = desk_.input;
    if (input.keyPressed(SDLK_ESCAPE)) {
        menu_.back();
        return;
    }
    ShelfEntry const* level = nullptr;
    auto const choice = menu_.draw(desk_, play_ ? play_->file() : std::filesystem::path(), level);
    if (level != nullptr) {
        tryOpen(*level);
        return;
    }
    if (!choice) {
        return;
    }
    menu_.close();
    switch (*choice) {
    case MenuChoice::resume:
        break;
    case MenuChoice::restart:
        play_->restart();
        break;
    case MenuChoice::toTitle:
        showTitle();
        break;
    case MenuChoice::quit:
        going_ = false;
        break;
    }
}

void GameApp::update(double seconds) {
    if (menu_.isOpen()) {
        if (play_) {
            play_->updateBehindMenu();
        } else {
            title_.update(seconds, true);
        }
        updateMenu();
        return;
    }
    if (play_) {
        follow(play_->update(seconds));
        return;
    }
    TitleChoice const choice = title_.update(seconds, false);
    if (desk_.input.keyPressed(SDLK_F11)) {
        toggleFullscreen();
    }
    if (choice.level != nullptr) {
        tryOpen(*choice.level);
    } else if (choice.settings) {
        menu_.open(MenuPage::settings);
    }
    going_ = going_ && !choice.quit;
}

bool GameApp::frame(double seconds) {
    desk_.input.poll();
    desk_.gui.beginFrame(desk_.input, seconds);
    desk_.layout.beginFrame();
    update(seconds);
    desk_.window.beginFrame(render::palette::paper);
    if (play_) {
        play_->draw();
    } else {
        title_.draw();
    }
    desk_.toasts.draw(seconds);
    desk_.gui.endFrame();
    if (play_) {
        play_->takePictures();
    }
    desk_.window.present();
    return going_ && !desk_.input.quit();
}

} // namespace trembler::ui
