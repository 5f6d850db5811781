// trembler: the program.
#include "game/app/commands.hpp"
#include "game/app/standard_streams.hpp"

#include <exception>
#include <iostream>

namespace {

int runCommand(int argc, char** argv) {
    int result = trembler::exitSolved;
    CLI::App program{
        "Trembler: a world in which physics, not scripts, makes things work.\n"
        "\n"
        "  trembler play                                          the game\n"
        "  trembler play levels/first/1-first-contact.json        one level\n"
        "  trembler edit my-level.json                            make or change a level\n"
        "  trembler run LEVEL --solution NAME                     replay a recorded solution, no window\n"
        "  trembler run LEVEL --trace account.jsonl               write every event with its causes\n"
        "  trembler run LEVEL --sound it.wav                      write its sound\n"
        "  trembler why LEVEL --solution NAME                     why a goal was met, or was not\n"
        "  trembler clip LEVEL --solution NAME --out it.webp      a moving picture of a run\n"
        "  trembler verify                                        check every level\n"
        "  trembler report LEVEL                                  what its solutions need, and how exactly\n"
        "  trembler solve LEVEL                                   search for solutions\n"
        "  trembler components                                    all components and their schedule\n"
        "  trembler accuracy                                      errors and times of all detail levels\n"
        "\n"
        "Each command has its own --help."};
    program.set_version_flag("--version", "Trembler " TREMBLER_VERSION);
    program.require_subcommand(1);
    trembler::addPlayCommand(program, result);
    trembler::addEditCommand(program, result);
    trembler::addRunCommand(program, result);
    trembler::addVerifyCommand(program, result);
    trembler::addReportCommand(program, result);
    trembler::addSolveCommand(program, result);
    trembler::addComponentsCommand(program, result);
    trembler::addSchemaCommand(program, result);
    trembler::addAccuracyCommand(program, result);
    trembler::addScreenshotCommand(program, result);
    trembler::addClipCommand(program, result);
    trembler::addKeysCommand(program, result);
    trembler::addModCommand(program, result);
    trembler::addWhyCommand(program, result);
    try {
        program.parse(argc, argv);
    } catch (CLI::Success const& help) {
        return program.exit(help);
    } catch (CLI::ParseError const& error) {
        program.exit(error);
        return trembler::exitBadInput;
    } catch (std::exception const& error) {
        std::cerr << "trembler: " << error.what() << "\n";
        return trembler::exitBadInput;
    }
    return result;
}

} // namespace

int main(int argc, char** argv) {
    trembler::StandardStreams streams;
    return streams.finish(runCommand(argc, argv));
}
