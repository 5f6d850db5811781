#include "game/ui/app/play.hpp"

#include "audio/device/loudspeaker.hpp"
#include "game/ui/app/app.hpp"
#include "game/ui/app/game_loop.hpp"
#include "game/ui/headless/run_sound.hpp"
#include "game/ui/headless/screenshot.hpp"
#include "game/ui/shared/kept/user_folders.hpp"
#include "game/ui/shared/shown_faults.hpp"
#include "puzzle/checks/checked_level.hpp"
#include "runtime/file/folders.hpp"
#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/read/read_level.hpp"

#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <iostream>

namespace trembler::ui {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::uint64_t usualFrames = 600;
/// Frames simulated after success, so that the picture shows the solved state and not the moment before.
constexpr std::uint64_t encore = 45;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The level to show if none is named: the first with a recorded solution.
fs::path firstLevel(GameData const& gameData) {
    LevelCatalog const catalog(gameData.registry, gameData.home / "levels");
    fs::path first;
    for (CatalogGroup const& group : catalog.groups()) {
        for (CatalogEntry const& entry : group.levels) {
            if (!entry.trouble.empty()) {
                continue;
            }
            if (!loadLevel(gameData.registry, entry.file).solutions.empty()) {
                return entry.file;
            }
            first = first.empty() ? entry.file : first;
        }
    }
    if (first.empty()) {
        throw std::invalid_argument("There is no level to play in " + (gameData.home / "levels").string() +
                                    ".");
    }
    return first;
}

/// Steps the session to its end and prints a line every second. Returns the frame in which it was solved.
std::optional<std::uint64_t> playOut(Session& session, std::uint64_t frames, std::ostream& out) {
    std::optional<std::uint64_t> solved;
    auto printed = Clock::now();
    for (std::uint64_t frame = 1; frame <= frames; ++frame) {
        session.step();
        if (session.solved() && !solved) {
            solved = frame;
        }
        if (solved && frame >= *solved + encore) {
            break;
        }
        if (secondsSince(printed) > 1) {
            printed = Clock::now();
            out << fmt::format("  {} of {} frames\n", frame, frames) << std::flush;
        }
    }
    return solved;
}

void writePicture(Session const& session, fs::path const& file, std::ostream& out) {
    try {
        render::Window window({.size = {1280, 720}, .mode = render::WindowMode::Offscreen});
        writePng(pictureOf(window, session), file);
        std::error_code ignored;
        fs::path const where = fs::absolute(file, ignored);
        out << "A picture of the last frame is in " << where.string() << ".\n";
    } catch (render::WindowError const& error) {
        out << "No picture was made, because drawing is not possible here. " << error.what() << "\n";
    } catch (render::RenderError const& error) {
        out << "No picture was made. " << error.what() << "\n";
    }
}

} // namespace

int playWithoutDisplay(GameData const& gameData, PlayOptions const& options, std::ostream& out) {
    fs::path const file = options.level.empty() ? firstLevel(gameData) : options.level;
    Session session(gameData.registry, gameData.parts,
                    loadPlayable(gameData.registry, gameData.parts, file, options.world));
    LevelFile const& level = session.level();
    out << fmt::format("Playing \"{}\" ({})", level.title, gameData.shortName(file));
    std::uint64_t frames = usualFrames;
    if (level.solutions.empty()) {
        out << ", which has no recorded solution, with an empty toolbox.\n";
    } else {
        Solution const solution = level.solutions.front();
        session.load(solution);
        frames = solution.frames ? static_cast<std::uint64_t>(*solution.frames) : usualFrames;
        out << fmt::format(" with its recorded solution \"{}\".\n", solution.name);
    }
    auto const start = Clock::now();
    auto const solved = playOut(session, frames, out);
    double const wall = secondsSince(start);
    for (GoalStatus const& goal : session.judge().status()) {
        out << fmt::format("  [{}] {}\n", goal.met ? "x" : " ", goal.text);
    }
    double const simulated = session.world().time();
    if (solved) {
        out << fmt::format("Solved after {:.1f} s ({} frames), simulated in {:.2f} s.\n",
                           static_cast<double>(*solved) * frameDuration, *solved, wall);
    } else {
        out << fmt::format("Not solved within {:.1f} s ({} frames), simulated in {:.2f} s.\n", simulated,
                           session.world().frame(), wall);
    }
    fs::path const picture = options.picture.empty()
                                 ? options.pictures / ("trembler-" + file.stem().string() + ".png")
                                 : options.picture;
    makeFolder(options.pictures);
    writePicture(session, picture, out);
    return solved ? 0 : 1;
}

int playInWindow(GameData const& gameData, PlayOptions const& options) {
    render::Window window({.title = "Trembler", .size = {1280, 720}});
    Loudspeaker loudspeaker(
        {.synthesiser = {}, .output = {}, .sampleFolders = sampleFolders(gameData, options.level)},
        [](std::string const& text) { std::cout << text << std::endl; });
    GameApp app(window, gameData.registry, gameData.parts,
                {.levels = gameData.home / "levels",
                 .pictures = options.pictures.empty() ? usualPicturesFolder() : options.pictures,
                 .profile = Profile::usualFile(),
                 .nowhere = Profile::usualFile().empty(),
                 .world = options.world,
                 .loudspeaker = &loudspeaker,
                 .levelData = options.levelData,
                 .mods = options.mods,
                 .modData = options.modData,
                 .faults = gameData.ownPartFaults,
                 .damagedParts = gameData.damagedOwnParts});
    if (options.fullscreen) {
        window.setFullscreen(true);
    }
    if (options.edits) {
        app.edit(options.level);
    } else if (!options.level.empty()) {
        try {
            app.open(options.level);
        } catch (std::exception const& error) { // reported where a player without a terminal sees it, too
            std::cerr << error.what() << std::endl;
            app.context().toasts.add(shownError(error), render::ToastKind::Trouble, 60);
        }
    }
    GameLoop loop(app, window);
    while (loop.turn()) {
    }
    app.keepAtOnce();
    // The window is about to be gone.
    for (auto const& why : {app.context().profile.unwritten(), app.context().builds.unwritten()}) {
        if (why) {
            std::cerr << why->what() << std::endl;
        }
    }
    return 0;
}

int play(GameData const& gameData, PlayOptions const& options) {
    try {
        return playInWindow(gameData, options);
    } catch (render::WindowError const& error) {
        if (error.kind() == render::WindowError::Kind::Other) {
            throw;
        }
        std::cout << error.what() << "\n\n";
    }
    auto const ofLevel =
        options.levelData && !options.level.empty() ? options.levelData(options.level) : nullptr;
    return playWithoutDisplay(ofLevel == nullptr ? gameData : *ofLevel, options, std::cout);
}

} // namespace trembler::ui
