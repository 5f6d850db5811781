// The processor time that the window takes: for each level, including those of the mods that come with the
// program, a frame of its simulation and a picture of it, with its first recorded solution; the start up to
// the title screen; and a window at rest.
//
//     bench_window [LEVEL...] [--runs N] [--rest SECONDS] [--markdown]
//
// The window at rest is one on a display if there is one, for example Xvfb's. All in processor time, because
// the machine is shared. Of a picture only the processor's side is measured: OpenGL receives every command,
// but draws no pixels. Exit status 1 if a limit is exceeded. With --markdown prints the page
// docs/measurements/window.md.
#include "audio/effect/properties/sounds.hpp"
#include "bench/window/clocks.hpp"
#include "bench/window/rest.hpp"
#include "game/ui/app/game_loop.hpp"
#include "game/ui/play/play_screen.hpp"
#include "lua/mods/mod.hpp"
#include "puzzle/data/game_data.hpp"
#include "runtime/level/read/read_level.hpp"

#include <CLI/CLI.hpp>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using namespace trembler;
namespace fs = std::filesystem;

constexpr double mostPerFrame = 4;         // ms, of the simulation and of a picture
constexpr double mostToTitle = 1;          // s
constexpr double mostAtRest = 0.02;        // of a processor
constexpr std::size_t framesOfLevel = 600; // at most
constexpr std::size_t drawnEvery = 4;      // frames

struct Arguments {
    std::vector<fs::path> levels;
    int runs = 3;
    double rest = 3; // s
    bool markdown = false;
    bool title = false;
};

struct LevelCost {
    std::string level;
    bench::FrameTimes simulation;
    bench::FrameTimes picture;
};

/// All the game's data, with the mods that the level names.
std::shared_ptr<GameData const> dataFor(fs::path const& level) {
    Problems problems;
    auto mods = lua::findMods(lua::modsNamedBy(level), lua::modFolders({}, level, homeFolder()),
                              level.string(), problems);
    problems.throwIfAny();
    return std::make_shared<GameData const>(std::move(mods));
}

ui::GameOptions optionsOf(GameData const& data) {
    return {.levels = data.home / "levels",
            .profile = {},
            .world = {},
            .steady = true,
            .levelData = [](fs::path const& level) {
                return lua::modsNamedBy(level).empty() ? nullptr : dataFor(level);
            }};
}

/// The game's levels, then those of the mods that come with it.
std::vector<fs::path> allLevels(GameData const& data) {
    std::vector<fs::path> levels = data.levels();
    for (fs::path const& mod : lua::listMods(std::vector{data.home / "mods"})) {
        std::vector<fs::path> ofMod;
        for (auto const& file : fs::directory_iterator(mod / "levels")) {
            ofMod.push_back(file.path());
        }
        std::sort(ofMod.begin(), ofMod.end());
        levels.insert(levels.end(), ofMod.begin(), ofMod.end());
    }
    return levels;
}

std::size_t framesOf(LevelFile const& level) {
    if (level.solutions.empty() || !level.solutions.front().frames) {
        return framesOfLevel;
    }
    return std::min(static_cast<std::size_t>(*level.solutions.front().frames), framesOfLevel);
}

void simulate(GameData const& data, LevelFile const& level, LevelCost& cost) {
    Session session(data.registry, data.parts, level, {});
    if (!level.solutions.empty()) {
        session.load(level.solutions.front());
    }
    session.start();
    Subscription const heard = session.world().want<Sounds>(); // as in the window
    for (std::size_t frame = 0; frame < framesOf(level); ++frame) {
        cost.simulation.add(frame, bench::threadMilliseconds([&] { session.step(); }));
    }
}

void draw(ui::GameApp& app, fs::path const& file, LevelCost& cost) {
    app.open(file);
    auto& play = dynamic_cast<ui::PlayScreen&>(app.screen());
    LevelFile const level = play.session().level();
    if (!level.solutions.empty()) {
        play.session().load(level.solutions.front());
        play.worldChanged();
    }
    play.commands().run("run");
    app.frame(0, true); // pictures of parts, and other things that are made once
    std::size_t drawn = 0;
    for (std::size_t frame = 0; frame < framesOf(level); ++frame) {
        app.frame(frameDuration, false);
        if (frame % drawnEvery == 0) {
            // No time passes, so this is drawing alone, with all cards and panels.
            cost.picture.add(drawn++, bench::threadMilliseconds([&] { app.frame(0, true); }));
        }
    }
}

/// Leaves out the work of a graphics card: the corners of shapes, and all pixels.
class WithoutCard {
public:
    WithoutCard() {
        glEnable(GL_RASTERIZER_DISCARD);
        epoxy_glDrawArraysInstanced = [](GLenum, GLint, GLsizei, GLsizei) {};
    }
    ~WithoutCard() {
        epoxy_glDrawArraysInstanced = draw_;
        glDisable(GL_RASTERIZER_DISCARD);
    }
    WithoutCard(WithoutCard const&) = delete;
    WithoutCard& operator=(WithoutCard const&) = delete;

private:
    decltype(epoxy_glDrawArraysInstanced) draw_ = epoxy_glDrawArraysInstanced; // epoxy's own variable
};

std::vector<LevelCost> measureLevels(GameData const& data, Arguments const& arguments) {
    render::Window window({.size = {1280, 720}, .mode = render::WindowMode::Offscreen});
    WithoutCard const withoutCard;
    ui::GameApp app(window, data.registry, data.parts, optionsOf(data));
    std::vector<LevelCost> all;
    for (fs::path const& file : arguments.levels.empty() ? allLevels(data) : arguments.levels) {
        LevelCost cost{fs::path(data.shortName(file)).replace_extension().string(), {}, {}};
        auto const own = dataFor(file);
        LevelFile const level = loadLevel(own->registry, file);
        for (int run = 0; run < arguments.runs; ++run) {
            simulate(*own, level, cost);
            draw(app, file, cost);
        }
        std::fprintf(stderr, "%-48s frame %6.3f %6.3f ms, picture %6.3f %6.3f ms\n", cost.level.c_str(),
                     cost.simulation.median(), cost.simulation.worst(), cost.picture.median(),
                     cost.picture.worst());
        all.push_back(std::move(cost));
    }
    return all;
}

/// Everything that happens before the first picture of the title is shown, except opening the loudspeaker,
/// which the sound system's own thread does.
int showTitle() {
    GameData const data;
    render::Window window({.size = {1280, 720}, .mode = render::WindowMode::Offscreen});
    ui::GameApp app(window, data.registry, data.parts, optionsOf(data));
    app.frame(frameDuration, true);
    std::_Exit(0);
}

/// s of processor time of a process that ends when the title has been shown, including the loading of the
/// program: the least of several runs.
double timeToTitle(int runs) {
    std::string const self = fs::read_symlink("/proc/self/exe").string();
    double least = 1e300;
    for (int run = 0; run < runs; ++run) {
        std::string program = self;
        std::string flag = "--title";
        std::array<char*, 3> words{program.data(), flag.data(), nullptr};
        pid_t child = 0;
        if (posix_spawn(&child, self.c_str(), nullptr, nullptr, words.data(), environ) != 0) {
            throw std::runtime_error("the program cannot be started");
        }
        rusage used{};
        int status = 0;
        if (wait4(child, &status, 0, &used) != child || status != 0) {
            throw std::runtime_error("the title cannot be shown");
        }
        auto const seconds = [](timeval const& time) {
            return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
        };
        least = std::min(least, seconds(used.ru_utime) + seconds(used.ru_stime));
    }
    return least;
}

/// A number and its ratio to the limit, as cells of a table.
std::string cells(double value, double limit, bool& held) {
    held = held && value <= limit;
    return fmt::format(" {:.3f} | {:.2f}{} |", value, value / limit, value <= limit ? "" : " **missed**");
}

constexpr char const* heading = R"(# What the window costs the processor

This page is made by `xvfb-run -a build/bench/bench_window --markdown >docs/measurements/window.md`. Times are processor time,
of each frame the least in some runs, as runs repeat to the bit. A *frame* is 1/60 s of the simulation on one thread, with the first
recorded solution, and with what the window asks of the world, such as sounds. A *picture* is everything that the program does
to show one at 1280×720, cards and panels included, up to the data that OpenGL gets; the graphics card's part is left out.
*Worst* is what the worst 1 % of the frames take at least. *Of the limit* is a ratio: up to 1 the limit is held.
)";

bool printLevels(std::vector<LevelCost> const& all) {
    bool held = true;
    std::printf("\n## Levels\n\nThe limits are %g ms for a frame and %g ms for a picture.\n\n", mostPerFrame,
                mostPerFrame);
    std::puts("| level | frame, ms | worst | of the limit | picture, ms | worst | of the limit |");
    std::puts("|---|---|---|---|---|---|---|");
    for (LevelCost const& cost : all) {
        std::printf("| %s | %.3f |%s %.3f |%s\n", cost.level.c_str(), cost.simulation.median(),
                    cells(cost.simulation.worst(), mostPerFrame, held).c_str(), cost.picture.median(),
                    cells(cost.picture.worst(), mostPerFrame, held).c_str());
    }
    return held;
}

bool printRest(double title, std::vector<bench::RestCost> const& rests, double waking) {
    bool held = true;
    std::printf(
        "\n## Start and rest\n\nA window at rest draws no picture that shows nothing new. The limits are "
        "%g s to the title and %g of a processor at rest.\n\n",
        mostToTitle, mostAtRest);
    std::puts("| | measured | of the limit | pictures drawn |\n|---|---|---|---|");
    std::printf("| from the start to the title, s |%s 1 |\n", cells(title, mostToTitle, held).c_str());
    for (bench::RestCost const& rest : rests) {
        std::printf("| at rest: %s, share of a processor |%s %llu |\n", rest.where.c_str(),
                    cells(rest.share, mostAtRest, held).c_str(), static_cast<unsigned long long>(rest.drawn));
        held = held && rest.drawn == 0;
    }
    if (waking > 0) {
        std::printf(
            "\nMeasured without a display. Of the time at rest, %.3f is what a thread takes on this machine "
            "that does nothing but\nwake every millisecond, as SDL does without a display. With one it waits "
            "for events.\n",
            waking);
    } else {
        std::puts("\nThe window at rest was one on a display, where SDL waits for events.");
    }
    return held;
}

} // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CLI::App program("What the window costs the processor.");
    program.add_option("LEVEL", arguments.levels, "Only these");
    program.add_option("--runs", arguments.runs, "Of every level and of the start")
        ->check(CLI::Range(1, 1000));
    program.add_option("--rest", arguments.rest, "Seconds for which a window at rest is watched")
        ->check(CLI::Range(0.5, 600.0));
    program.add_flag("--markdown", arguments.markdown, "The page docs/measurements/window.md");
    program.add_flag("--title", arguments.title, "Only show the title, and end");
    CLI11_PARSE(program, argc, argv);
    if (arguments.title) {
        return showTitle();
    }
    GameData const data;
    fs::path const level = data.home / "levels/first/1-first-contact.json";
    fs::path const withMod = data.home / "mods/wind/levels/1-a-fair-wind.json";
    std::vector<LevelCost> const levels = measureLevels(data, arguments);
    double const title = timeToTitle(arguments.runs);
    ui::GameOptions const options = optionsOf(data);
    auto const rest = [&](std::string where, fs::path const& opened, bench::Before before) {
        return bench::measureRest(std::move(where), data, options, arguments.rest, opened, before);
    };
    std::vector<bench::RestCost> const rests{
        rest("the title", {}, bench::Before::nothing), rest("a level", level, bench::Before::nothing),
        rest("a level with a mod", withMod, bench::Before::nothing),
        rest("a level with a time budget", level, bench::Before::setBudget),
        rest("the menu over a level", level, bench::Before::openMenu)};
    double const waking = bench::hasDisplay() ? 0 : bench::shareOfWaking(arguments.rest);
    if (arguments.markdown) {
        std::fputs(heading, stdout);
    }
    bool const heldByLevels = printLevels(levels);
    bool const heldAtRest = printRest(title, rests, waking);
    return heldByLevels && heldAtRest ? 0 : 1;
}
