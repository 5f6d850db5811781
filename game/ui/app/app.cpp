#include "game/ui/app/app.hpp"

#include "game/ui/app/command_lists.hpp"
#include "game/ui/app/dropped_file.hpp"
#include "game/ui/app/title/title_screen.hpp"
#include "game/ui/edit/edit_screen.hpp"
#include "game/ui/play/mouse/second_player.hpp"
#include "game/ui/play/play_screen.hpp"
#include "game/ui/shared/kept/damaged_parts.hpp"
#include "game/ui/shared/shown_faults.hpp"
#include "game/ui/shared/texts.hpp"
#include "puzzle/campaign/free_play.hpp"
#include "render/draw/palette.hpp"
#include "runtime/file/folders.hpp"
#include "runtime/file/output_file.hpp"

#include <algorithm>
#include <exception>
#include <optional>
#include <system_error>
#include <utility>

namespace trembler::ui {
namespace {

namespace fs = std::filesystem;

/// A file or folder beside the profile; empty if nothing is kept.
fs::path besideProfile(fs::path const& profile, char const* name) {
    return profile.empty() ? fs::path() : profile.parent_path() / name;
}

} // namespace

GameApp::GameApp(render::Window& window, Registry const& registry, PartLibrary const& parts,
                 GameOptions const& options)
    : options_(withNewParts(options)),
      context_{.window = window,
               .registry = registry,
               .parts = parts,
               .gui = render::Gui(window, {.steady = options.steady}),
               .pads = {},
               .input = render::InputEvents(window, context_.pads),
               .canvas = {},
               .toasts = {},
               .layout = {},
               .focus = {},
               .catalog = PartCatalog(parts, context_.canvas),
               .levels = options.catalog != nullptr
                             ? *options.catalog
                             : LevelCatalog(registry, options.levels,
                                            {.data = options_.levelData, .mods = options.mods}),
               .pictures = LevelPictures(registry, parts, context_.canvas, options_.levelData),
               .profile = Profile(options.profile),
               .builds = KeptBuilds(besideProfile(options.profile, "builds")),
               .kinds = {},
               .keys = KeyBindings(commandLists()),
               .pending = PendingWrites(context_.toasts),
               .recorder = Recorder(options.pictures),
               .solutions =
                   SavedSolutions(options.profile.empty() ? options.pictures / "solutions"
                                                          : besideProfile(options.profile, "solutions")),
               .loudspeaker = options.loudspeaker,
               .stopwatch = options.stopwatch},
      screen_(std::make_unique<TitleScreen>(context_)) {
    // A cursor that blinks would have the window drawn all the time.
    ImGui::GetIO().ConfigInputTextCursorBlink = false;
    applySettings(context_);
    std::vector<std::string> troubles = context_.profile.troubles();
    for (std::string& trouble : context_.keys.load(context_.profile.keys())) {
        troubles.push_back(std::move(trouble));
    }
    for (Diagnostic const& fault : options.faults) {
        troubles.push_back(shownFault(fault));
    }
    for (std::string& trouble : moveDamagedAside(options.damagedParts)) {
        troubles.push_back(std::move(trouble));
    }
    if (options.nowhere) {
        troubles.emplace_back(text("kept.nowhere"));
    }
    for (std::string const& trouble : troubles) {
        context_.toasts.add(trouble, render::ToastKind::Trouble, 12);
    }
}

GameOptions GameApp::withNewParts(GameOptions options) const {
    options.levelData = [this, stated = options.levelData](fs::path const& level) {
        auto data = stated ? stated(level) : nullptr;
        return data != nullptr ? data : newest_;
    };
    return options;
}

GameApp::~GameApp() {
    screen_->leave();
    keepAtOnce();
}

void GameApp::keepAtOnce() {
    screen_->keep();
    context_.profile.finish();
    context_.builds.finish();
    context_.pending.finish();
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
    show(std::make_unique<EditScreen>(
        context_, level,
        EditOptions{
            .data = plain_,
            .levelData = options_.levelData,
            .partsMade = [this](std::shared_ptr<GameData const> data) { newest_ = plain_ = std::move(data); },
            .world = options_.world,
            .recovery = options_.profile.empty() ? std::filesystem::path() : edit::recoveryFolder()}));
    menu_.close();
}

void GameApp::showTitle() {
    show(std::make_unique<TitleScreen>(context_));
}

void GameApp::tryOpen(std::filesystem::path const& level) {
    try {
        tryOpen(level, options_.levelData ? options_.levelData(level) : nullptr);
    } catch (std::exception const& error) {
        context_.toasts.add(shownError(error), render::ToastKind::Trouble, 10);
    }
}

void GameApp::tryOpen(std::filesystem::path const& level, std::shared_ptr<GameData const> data) {
    try {
        show(std::make_unique<PlayScreen>(context_, level, std::move(data), options_.world));
        menu_.close();
    } catch (std::exception const& error) {
        context_.toasts.add(shownError(error), render::ToastKind::Trouble, 10);
    }
}

void GameApp::openFreePlay() {
    // A file like that of any level, written again each time, as there may be more parts than before.
    std::shared_ptr<GameData const> data;
    fs::path file = besideProfile(options_.profile, "free-play.json");
    if (file.empty()) {
        file = options_.pictures / "free-play.json";
    }
    try {
        makeFolder(file.parent_path());
        // In every language, as the player may choose another one while it is played.
        Translations texts;
        for (Language const& language : languages()) {
            texts[std::string(language.id)] = {
                textOfLanguage(language.id, "free.title"), textOfLanguage(language.id, "free.text"), {}, {}};
        }
        OfferedMods offered = options_.modData ? offeredMods(options_.mods, options_.modData) : OfferedMods();
        tellOfLeftOut(offered.leftOut);
        data = offered.data ? std::move(offered.data) : newest_;
        writeFile(file, freePlayLevel(data ? data->parts : context_.parts, text("free.title"),
                                      text("free.text"), texts, offered.names));
    } catch (OutputError const& error) {
        std::error_code unknown;
        if (!fs::exists(file, unknown)) { // else that of the last time is as good, but for new parts
            context_.toasts.add(notWritten(Owned::level, error), render::ToastKind::Trouble, 10);
            return;
        }
        tryOpen(file); // with the mods that it names
        return;
    } catch (std::exception const& error) {
        context_.toasts.add(shownError(error), render::ToastKind::Trouble, 10);
        return;
    }
    tryOpen(file, std::move(data));
}

void GameApp::tellOfLeftOut(std::vector<LeftOutMod> const& mods) {
    constexpr std::size_t mostTold = 3;
    for (std::size_t i = 0; i < std::min(mods.size(), mostTold); ++i) {
        context_.toasts.add(textWith("free.without_mod", mods[i].name, shownFault(mods[i].fault)),
                            render::ToastKind::Trouble, 12);
    }
    if (mods.size() > mostTold) {
        context_.toasts.add(textWith("free.without_more", mods.size() - mostTold), render::ToastKind::Trouble,
                            12);
    }
}

void GameApp::keepOwned(double seconds) {
    context_.profile.pass(seconds);
    context_.builds.pass(seconds);
    context_.pending.pass(seconds);
    context_.pending.look(Owned::progress, context_.profile.unwritten());
    context_.pending.look(Owned::build, context_.builds.unwritten());
    std::vector<DamagedFile> damaged = context_.builds.takeDamaged();
    for (DamagedFile& one : context_.solutions.takeDamaged()) {
        damaged.push_back(std::move(one));
    }
    for (DamagedFile const& one : damaged) {
        context_.toasts.add(inWords(one), render::ToastKind::Trouble, 12);
    }
    std::vector<InputError> notRead = context_.builds.takeNotRead();
    for (InputError& one : context_.solutions.takeNotRead()) {
        notRead.push_back(std::move(one));
    }
    for (InputError const& one : notRead) {
        context_.toasts.add(notReadable(one), render::ToastKind::Trouble, 12);
    }
}

void GameApp::takeKinds() {
    if (auto found = context_.kinds.take()) {
        bool const first = context_.profile.progress().of(found->levelId).kinds.empty();
        if (context_.profile.addKind(found->levelId, std::move(found->kind)) && !first) {
            context_.toasts.add(text("levels.other_kind"), render::ToastKind::Success, 6);
        }
    }
}

void GameApp::toggleFullscreen() {
    Settings settings = context_.profile.settings();
    settings.fullscreen = !settings.fullscreen;
    changeSettings(context_, settings);
}

void GameApp::quit() {
    keepAtOnce();
    bool const lost =
        context_.profile.unwritten() || context_.builds.unwritten() || context_.pending.waiting() > 0;
    warned_ = warned_ && lost;
    if (lost && !std::exchange(warned_, true)) {
        menu_.close();
        context_.toasts.add(text("kept.quit_again"), render::ToastKind::Trouble, 10);
        return;
    }
    going_ = false;
}

void GameApp::follow(ScreenRequest const& asked) {
    struct Follower {
        GameApp& app;
        void operator()(request::OpenMenu const& menu) const { app.menu_.open(menu.page); }
        void operator()(request::OpenLevel const& wanted) const { app.tryOpen(wanted.level); }
        void operator()(request::OpenFreePlay const&) const {
            app.menu_.close();
            app.openFreePlay();
        }
        void operator()(request::OpenEditor const& wanted) const { app.edit(wanted.level); }
        void operator()(request::ShowTitle const&) const { app.showTitle(); }
        void operator()(request::SwitchFullscreen const&) const { app.toggleFullscreen(); }
        void operator()(request::Quit const&) const { app.quit(); }
    };
    bool const stays = std::holds_alternative<request::OpenMenu>(asked) ||
                       std::holds_alternative<request::SwitchFullscreen>(asked);
    if (!stays && !screen_->mayLeaveFor(asked)) {
        menu_.close();
        return;
    }
    std::visit(Follower{*this}, asked);
}

void GameApp::takeDropped(std::filesystem::path const& file) {
    DroppedFile const dropped = lookAtDropped(file);
    if (dropped.kind == DroppedFile::Kind::level) {
        follow(request::OpenLevel{file});
        return;
    }
    std::string why = dropped.why;
    if (dropped.kind == DroppedFile::Kind::solution) {
        LoadableSolutions* const loadable = screen_->loadableSolutions();
        why = loadable != nullptr ? loadable->receive(file) : text("solutions.no_level");
    }
    if (why.empty()) {
        menu_.close();
    } else {
        context_.toasts.add(why, render::ToastKind::Trouble, 10);
    }
}

void GameApp::update(double seconds) {
    for (std::filesystem::path const& file : context_.input.dropped()) {
        takeDropped(file);
    }
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

bool GameApp::lively() const {
    bool const moves = menu_.isOpen() ? context_.pictures.waiting() : !screen_->still();
    return moves || !context_.input.events().empty() || context_.toasts.count() > 0 ||
           context_.kinds.busy() || context_.letters.busy() || screen_->keepsPicture();
}

bool GameApp::frame(double seconds, bool seen) {
    using render::PadUse;
    bool const two = screen_->hasSecondHand() && !menu_.isOpen();
    bool const last = context_.profile.settings().padIsSecond;
    context_.pads.setUse(!two ? PadUse::together : last ? PadUse::lastApart : PadUse::secondApart);
    if (two) {
        context_.pads.setSecondButtons(secondPadButtons(context_.keys));
    }
    context_.input.poll();
    context_.letters.takeInput(context_.input, context_.keys, seconds);
    context_.pictures.beginFrame();
    takeKinds();
    bool const typing = context_.letters.fieldHasKeys();
    context_.gui.beginFrame(context_.input, seconds, [&](SDL_Event const& event) {
        return context_.widgetKeys.read(event, context_.keys, typing);
    });
    context_.menuKeys.read(context_.input.events(), context_.keys, context_.gui.wantsKeyboard());
    context_.letters.beginPicture();
    context_.layout.beginFrame();
    context_.focus.beginFrame();
    update(seconds);
    keepOwned(seconds);
    context_.letters.draw(context_.layout, context_.keys);
    clicks_.look(context_);
    bool const drawn = seen || screen_->keepsPicture();
    if (drawn) {
        context_.window.beginFrame(render::palette::paper);
        screen_->draw();
    }
    std::vector<Rect> kept; // cards, on which messages would hide words or buttons
    for (Placed const& card : context_.layout.cards()) {
        kept.push_back(card.rect);
    }
    context_.toasts.draw(seconds, kept); // seen or not, they grow older
    if (drawn) {
        if (screen_->keepsPicture()) {
            context_.gui.endFrame([this] { screen_->pictureComplete(); });
        } else {
            context_.gui.endFrame();
            screen_->pictureComplete();
        }
        context_.window.present();
    } else {
        context_.gui.dropFrame();
    }
    sinceNews_ = lively() ? 0 : sinceNews_ + seconds;
    // The screen may ask first, so only the event itself counts, not that there once was one.
    if (context_.input.quitAsked()) {
        follow(request::Quit{});
    }
    return going_;
}

} // namespace trembler::ui
