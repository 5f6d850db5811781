#include "game/ui/app/app.hpp"

#include "render/draw/palette.hpp"
#include "runtime/level/json/diagnostic.hpp"

namespace trembler::ui {

GameApp::GameApp(render::Window& window, Registry const& registry, PartLibrary const& parts,
                 GameOptions const& options)
    : options_(options), context_{.window = window,
                                  .registry = registry,
                                  .parts = parts,
                                  .gui = render::Gui(window, {.steady = options.steady}),
                                  .input = render::InputEvents(window),
                                  .canvas = {},
                                  .toasts = {},
                                  .layout = {},
                                  .catalog = PartCatalog(parts, context_.canvas),
                                  .levels = LevelCatalog(registry, options.levels),
                                  .profile = Profile(options.profile),
                                  .recorder = Recorder(options.pictures),
                                  .loudspeaker = options.loudspeaker},
      title_(context_) {
    applySettings(context_);
}

GameApp::~GameApp() = default;

void GameApp::open(std::filesystem::path const& level) {
    play_ = std::make_unique<PlayScreen>(context_, level, options_.world);
    menu_.close();
}

void GameApp::tryOpen(CatalogEntry const& entry) {
    try {
        open(entry.file);
    } catch (InputError const& error) {
        context_.toasts.add(error.what(), render::ToastKind::Trouble, 10);
    }
}

void GameApp::toggleFullscreen() {
    Settings settings = context_.profile.settings();
    settings.fullscreen = !settings.fullscreen;
    bool const shadows = context_.shadows;
    context_.profile.setSettings(settings);
    applySettings(context_);
    context_.shadows = shadows;
}

void GameApp::follow(PlayRequest request) {
    switch (request) {
    case PlayRequest::none:
        break;
    case PlayRequest::menu:
        menu_.open(MenuPage::main);
        break;
    case PlayRequest::levels:
        menu_.open(MenuPage::levels);
        break;
    case PlayRequest::help:
        menu_.open(MenuPage::help);
        break;
    case PlayRequest::fullscreen:
        toggleFullscreen();
        break;
    case PlayRequest::nextLevel:
        if (CatalogEntry const* const next = context_.levels.after(play_->file())) {
            tryOpen(*next);
        }
        break;
    }
}

void GameApp::updateMenu() {
    auto const& input = context_.input;
    if (input.keyPressed(SDLK_ESCAPE)) {
        menu_.back();
        return;
    }
    CatalogEntry const* level = nullptr;
    auto const choice = menu_.draw(context_, play_ ? play_->file() : std::filesystem::path(), level);
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
    if (context_.input.keyPressed(SDLK_F11)) {
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
    context_.input.poll();
    context_.gui.beginFrame(context_.input, seconds);
    context_.layout.beginFrame();
    update(seconds);
    context_.window.beginFrame(render::palette::paper);
    if (play_) {
        play_->draw();
    } else {
        title_.draw();
    }
    context_.toasts.draw(seconds);
    context_.gui.endFrame();
    if (play_) {
        play_->takePictures();
    }
    context_.window.present();
    return going_ && !context_.input.quit();
}

} // namespace trembler::ui
