#include "game/ui/app/app.hpp"

#include "game/ui/app/command_lists.hpp"
#include "game/ui/app/title_screen.hpp"
#include "game/ui/edit/edit_screen.hpp"
#include "game/ui/play/play_screen.hpp"
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
                                  .focus = {},
                                  .catalog = PartCatalog(parts, context_.canvas),
                                  .levels = LevelCatalog(registry, options.levels,
                                                         {.data = options.levelData, .mods = options.mods}),
                                  .profile = Profile(options.profile),
                                  .keys = KeyBindings(commandLists()),
                                  .recorder = Recorder(options.pictures),
                                  .loudspeaker = options.loudspeaker},
      screen_(std::make_unique<TitleScreen>(context_)) {
    applySettings(context_);
    std::vector<std::string> troubles = context_.profile.troubles();
    for (std::string& trouble : context_.keys.load(context_.profile.keys())) {
        troubles.push_back(std::move(trouble));
    }
    for (std::string const& trouble : troubles) {
        context_.toasts.add(trouble, render::ToastKind::Trouble, 12);
    }
}

GameApp::~GameApp() {
    screen_->leave();
}

void GameApp::show(std::unique_ptr<Screen> screen) {
    screen_->leave();
    screen_ = std::move(screen);
}

void GameApp::open(std::filesystem::path const& level) {
    show(std::make_unique<PlayScreen>(
        context_, level, options_.levelData ? options_.levelData(level) : nullptr, options_.world));
    menu_.close();
}

void GameApp::edit(std::filesystem::path const& level) {
    if (plain_ == nullptr) {
        plain_ = std::make_shared<GameData const>();
    }
    // Without a profile nothing is kept, recoveries included.
    show(std::make_unique<EditScreen>(context_, level,
                                      EditOptions{.data = plain_,
                                                  .levelData = options_.levelData,
                                                  .world = options_.world,
                                                  .recovery = options_.profile.empty()
                                                                  ? std::filesystem::path()
                                                                  : edit::recoveryFolder()}));
    menu_.close();
}

void GameApp::showTitle() {
    show(std::make_unique<TitleScreen>(context_));
}

void GameApp::tryOpen(std::filesystem::path const& level) {
    try {
        open(level);
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

void GameApp::follow(ScreenRequest const& asked) {
    struct Follower {
        GameApp& app;
        void operator()(request::OpenMenu const& menu) const { app.menu_.open(menu.page); }
        void operator()(request::OpenLevel const& wanted) const { app.tryOpen(wanted.level); }
        void operator()(request::OpenEditor const& wanted) const { app.edit(wanted.level); }
        void operator()(request::ShowTitle const&) const { app.showTitle(); }
        void operator()(request::SwitchFullscreen const&) const { app.toggleFullscreen(); }
        void operator()(request::Quit const&) const { app.going_ = false; }
    };
    bool const stays = std::holds_alternative<request::OpenMenu>(asked) ||
                       std::holds_alternative<request::SwitchFullscreen>(asked);
    if (!stays && !screen_->mayLeaveFor(asked)) {
        menu_.close();
        return;
    }
    std::visit(Follower{*this}, asked);
}

void GameApp::update(double seconds) {
    std::optional<ScreenRequest> asked;
    if (menu_.isOpen()) {
        screen_->updateBehindMenu(seconds);
        asked = menu_.draw(context_, *screen_);
    } else {
        asked = screen_->update(seconds);
    }
    if (asked) {
        follow(*asked);
    }
}

bool GameApp::frame(double seconds, bool seen) {
    context_.input.poll();
    context_.gui.beginFrame(context_.input, seconds);
    context_.layout.beginFrame();
    context_.focus.beginFrame();
    update(seconds);
    bool const drawn = seen || screen_->keepsPicture();
    if (drawn) {
        context_.window.beginFrame(render::palette::paper);
        screen_->draw();
    }
    context_.toasts.draw(seconds); // seen or not, they grow older
    if (drawn) {
        context_.gui.endFrame();
        screen_->pictureComplete();
        context_.window.present();
    } else {
        context_.gui.dropFrame();
    }
    // The screen may ask first, so only the event itself counts, not that there once was one.
    if (context_.input.quitAsked()) {
        follow(request::Quit{});
    }
    return going_;
}

} // namespace trembler::ui
