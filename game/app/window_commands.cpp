// trembler play and trembler screenshot: whatever draws.
#include "game/app/commands.hpp"

#ifndef TREMBLER_HEADLESS
#include "game/ui/play.hpp"
#include "game/ui/screenshot.hpp"
#endif

#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <unistd.h>

namespace trembler {
namespace {

struct PlayArguments {
    std::string level;
    std::string pictures = ".";
    bool fullscreen = false;
};

struct ScreenshotArguments {
    std::string level;
    std::string out;
    std::uint64_t frame = 0;
    std::string size = "1280x720";
    std::string solution;
    bool electricity = false;
    bool forces = false;
    bool contacts = false;
    bool bare = false;
};

#ifdef TREMBLER_HEADLESS

int play(PlayArguments const&) {
    throw std::runtime_error(
        "this build was made without the window; build it without -DTREMBLER_HEADLESS=ON");
}
int takeScreenshot(ScreenshotArguments const&) {
    throw std::runtime_error("this build was made without drawing; build it without -DTREMBLER_HEADLESS=ON");
}

#else

int play(PlayArguments const& arguments) {
    Workshop const workshop;
    ui::PlayOptions options;
    options.level = arguments.level;
    options.pictures = arguments.pictures;
    options.fullscreen = arguments.fullscreen;
    return ui::play(workshop, options);
}

render::Size sizeFrom(std::string const& text) {
    int width = 0;
    int height = 0;
    char rest = 0;
    constexpr int largest = 16384;
    if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) != 2 || width < 16 || height < 16 ||
        width > largest || height > largest) {
        throw std::invalid_argument(fmt::format(
            "--size {}: expected WIDTHxHEIGHT in pixels, 16 to {} each, like 1280x720", text, largest));
    }
    return {width, height};
}

int takeScreenshot(ScreenshotArguments const& arguments) {
    Workshop const workshop;
    ui::ScreenshotOptions options;
    options.level = arguments.level;
    options.file = arguments.out;
    options.frame = arguments.frame;
    options.size = sizeFrom(arguments.size);
    options.solution = arguments.solution;
    options.picture.overlays.electricity = arguments.electricity;
    options.picture.overlays.forces = arguments.forces;
    options.picture.overlays.contacts = arguments.contacts;
    options.picture.card = !arguments.bare;
    if (isatty(STDERR_FILENO) != 0 && arguments.frame >= 600) {
        options.progress = [last = arguments.frame](std::uint64_t done) {
            if (done % 600 == 0) {
                std::cerr << fmt::format("\r{} of {} frames", done, last) << std::flush;
            }
            if (done == last) {
                std::cerr << "\r                              \r";
            }
        };
    }
    ui::screenshot(workshop, options);
    std::cout << arguments.out << "\n";
    return exitSolved;
}

#endif

} // namespace

void addPlayCommand(CLI::App& program, int& result) {
    auto const arguments = std::make_shared<PlayArguments>();
    CLI::App* const command = program.add_subcommand(
        "play", "Play. Without a display: play the level's first recorded solution and leave a picture.");
    command->add_option("LEVEL", arguments->level, "Level file (default: the title screen)");
    command->add_option("--pictures", arguments->pictures, "Folder for the pictures and films that you take")
        ->capture_default_str();
    command->add_flag("--fullscreen", arguments->fullscreen, "Fill the whole screen");
    command->callback([arguments, &result] { result = guarded([&] { return play(*arguments); }); });
}

void addScreenshotCommand(CLI::App& program, int& result) {
    auto const arguments = std::make_shared<ScreenshotArguments>();
    CLI::App* const command = program.add_subcommand(
        "screenshot", "Draw a level as it is at some frame into a PNG; needs no display");
    command->add_option("LEVEL", arguments->level, "Level file")->required();
    command->add_option("--frame", arguments->frame, "Frames done, 60 are one second")
        ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{10'000'000}))
        ->capture_default_str();
    command->add_option("--out", arguments->out, "The PNG file to write")->required();
    command->add_option("--size", arguments->size, "Pixels")->capture_default_str();
    command->add_option("--solution", arguments->solution, "Recorded solution, by name or file");
    command->add_flag("--electricity", arguments->electricity, "With the electricity graph");
    command->add_flag("--forces", arguments->forces, "With magnetic forces");
    command->add_flag("--contacts", arguments->contacts, "With contacts");
    command->add_flag("--bare", arguments->bare, "Without title and goals");
    command->callback([arguments, &result] { result = guarded([&] { return takeScreenshot(*arguments); }); });
}

} // namespace trembler
