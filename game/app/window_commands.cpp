// trembler play and trembler screenshot: the commands that draw.
#include "game/app/commands.hpp"
#include "game/app/mods/mods.hpp"
#include "game/app/options/files/file_rules.hpp"
#include "game/app/options/files/outputs.hpp"
#include "game/app/options/run/solution_option.hpp"
#include "game/app/options/values/number_options.hpp"
#include "game/app/options/values/picture_size.hpp"
#include "game/app/progress.hpp"
#include "runtime/level/json/limits.hpp"

#ifndef TREMBLER_HEADLESS
#include "game/app/options/files/inputs.hpp"
#include "game/ui/app/play.hpp"
#include "game/ui/headless/screenshot.hpp"
#include "render/gl/png.hpp"
#endif

#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <unistd.h>
#include <vector>

namespace trembler {
namespace {

struct PlayArguments {
    std::string level;
    std::optional<std::string> pictures; // none: the desktop's, or without a display the current one
    bool fullscreen = false;
    std::vector<std::string> mods; // folders in which mods are looked for
};

struct ScreenshotArguments {
    std::string level;
    OutputTarget out;
    std::uint64_t frame = 0;
    std::string size = "1280x720";
    std::string solution;
    bool electricity = false;
    bool forces = false;
    bool contacts = false;
    bool bare = false;
    std::vector<std::string> mods; // folders in which mods are looked for
};

#ifdef TREMBLER_HEADLESS

int play(PlayArguments const&) {
    throw std::runtime_error(
        "this build was made without the window; build it without -DTREMBLER_HEADLESS=ON");
}
int editLevels(PlayArguments const&) {
    throw std::runtime_error(
        "this build was made without the window; build it without -DTREMBLER_HEADLESS=ON");
}
int takeScreenshot(ScreenshotArguments const&) {
    throw std::runtime_error("this build was made without drawing; build it without -DTREMBLER_HEADLESS=ON");
}

#else

int play(PlayArguments const& arguments) {
    // Those of the level's mods are loaded when it is opened, so that the window can say what is wrong with
    // them.
    GameData const gameData;
    std::shared_ptr<GameData const> last; // whose scripts' messages no window has shown
    ui::PlayOptions options;
    options.level = arguments.level;
    options.levelData = [&arguments, &last](std::filesystem::path const& level) {
        last = lua::modsNamedBy(level).empty()
                   ? nullptr
                   : std::shared_ptr<GameData const>(gameDataFor(level, arguments.mods));
        return last;
    };
    options.modData = [&arguments, &last](std::vector<std::string> const& names) {
        return last = std::shared_ptr<GameData const>(gameDataWith(names, arguments.mods));
    };
    options.mods = lua::listMods(lua::modFolders(arguments.mods, {}, gameData.home));
    options.pictures = arguments.pictures.value_or("");
    options.fullscreen = arguments.fullscreen;
    int const result = ui::play(gameData, options);
    if (last != nullptr) {
        reportScriptMessages(*last);
    }
    return result;
}

/// Files for the editor are not read here: it opens a wrong file, too, and shows its errors.
int editLevels(PlayArguments const& arguments) {
    GameData const gameData;
    ui::PlayOptions options;
    options.level = arguments.level;
    options.edits = true;
    options.levelData = [&arguments](std::filesystem::path const& level) {
        return lua::modsNamedBy(level).empty()
                   ? nullptr
                   : std::shared_ptr<GameData const>(gameDataFor(level, arguments.mods));
    };
    options.modData = [&arguments](std::vector<std::string> const& names) {
        return std::shared_ptr<GameData const>(gameDataWith(names, arguments.mods));
    };
    options.mods = lua::listMods(lua::modFolders(arguments.mods, {}, gameData.home));
    options.fullscreen = arguments.fullscreen;
    return ui::playInWindow(gameData, options);
}

int takeScreenshot(ScreenshotArguments const& arguments) {
    auto const data = gameDataFor(arguments.level, arguments.mods);
    GameData const& gameData = *data;
    ui::ScreenshotOptions options;
    options.frame = arguments.frame;
    PictureSize const size = *pictureSizeFrom(arguments.size); // checked with the other options
    options.size = {size.width, size.height};
    options.picture.overlays.electricity = arguments.electricity;
    options.picture.overlays.forces = arguments.forces;
    options.picture.overlays.contacts = arguments.contacts;
    options.picture.card = !arguments.bare;
    auto const session = sessionStated(gameData, arguments.level, arguments.solution);
    Outputs outputs;
    readsAll(outputs, gameData);
    outputs.reads(arguments.level);
    outputs.reads(arguments.solution);
    OutputFile* const file = outputs.add("--out", arguments.out, OutputFile::Content::binary);
    if (file->isStandardOutput() && isatty(STDOUT_FILENO) != 0) {
        throw OutputError("--out -: a terminal shows no pictures; expected a file, or standard output that "
                          "goes to another program");
    }
    Progress progress;
    options.progress = [&](std::uint64_t done) { progress.frames(done, arguments.frame); };
    options.picture.step = [&](std::string const& what) { progress.say(what); };
    render::Image const image = ui::screenshot(*session, options);
    progress.say("writing the picture");
    render::writePng(image, *file);
    progress.clear();
    outputs.finish();
    if (!file->isStandardOutput()) {
        std::cout << file->target().string() << "\n";
    }
    return exitSolved;
}

#endif

} // namespace

void addEditCommand(CLI::App& program, Work& work) {
    auto const arguments = std::make_shared<PlayArguments>();
    CLI::App* const command =
        program.add_subcommand("edit", "Make or change a level, in the window; needs a display");
    accepts(
        command->add_option("LEVEL", arguments->level, "Level file; it need not exist (default: a new level)")
            ->type_name(""),
        "a level file, or the name of a new one", faultOfEditedLevel);
    addModFolders(*command, arguments->mods);
    command->add_flag("--fullscreen", arguments->fullscreen, "Fill the whole screen");
    command->callback([arguments, &work] { work = [arguments] { return editLevels(*arguments); }; });
}

void addPlayCommand(CLI::App& program, Work& work) {
    auto const arguments = std::make_shared<PlayArguments>();
    CLI::App* const command = program.add_subcommand(
        "play", "Play. Without a display: play the level's first recorded solution and save a picture.");
    addLevel(*command, arguments->level, "Level file (default: the title screen)");
    addOutputFolder(*command, "--pictures", arguments->pictures,
                    "Folder for the pictures and clips that you take (default: Trembler in your folder of "
                    "pictures), or for the one without a display (default: .)");
    addModFolders(*command, arguments->mods);
    command->add_flag("--fullscreen", arguments->fullscreen, "Fill the whole screen");
    command->callback([arguments, &work] { work = [arguments] { return play(*arguments); }; });
}

void addScreenshotCommand(CLI::App& program, Work& work) {
    auto const arguments = std::make_shared<ScreenshotArguments>();
    CLI::App* const command = program.add_subcommand(
        "screenshot", "Draw a level at a given frame into a PNG file; needs no display");
    addLevel(*command, arguments->level, "Level file")->required();
    addNumber(*command, "--frame", arguments->frame, 0, limits::frames,
              "Frames to compute first, 60 are one second")
        ->default_str("0");
    addFile(*command, "--out", arguments->out, file_kinds::png, "The PNG file to write")->required();
    addPictureSize(*command, arguments->size);
    addSolution(*command, arguments->solution, "Recorded solution, by name or file");
    addModFolders(*command, arguments->mods);
    command->add_flag("--electricity", arguments->electricity, "Also draw the electricity graph");
    command->add_flag("--forces", arguments->forces, "With magnetic forces");
    command->add_flag("--contacts", arguments->contacts, "With contacts");
    command->add_flag("--bare", arguments->bare, "Without title and goals");
    command->footer(outputConvention);
    command->callback([arguments, &work] { work = [arguments] { return takeScreenshot(*arguments); }; });
}

} // namespace trembler
