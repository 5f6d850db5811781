#include "game/app/program.hpp"

#include "game/app/options/rule/refusal.hpp"
#include "game/app/options/rule/rule.hpp"

#include <exception>
#include <sstream>

namespace trembler {
namespace {

constexpr char const* about =
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
    "Each command has its own --help. An option that is empty, stated twice, unknown or out of its range is "
    "refused before anything runs, with exit status 2.";

/// A flag is on or it is not stated: "--brief=no" is a mistake, as it says the same as "--brief".
void refuseValuesOfFlags(CLI::App& command) {
    for (CLI::Option* const option : command.get_options()) {
        option->disable_flag_override();
    }
    for (CLI::App* const inner : command.get_subcommands([](CLI::App*) { return true; })) {
        refuseValuesOfFlags(*inner);
    }
}

} // namespace

void addCommands(CLI::App& program, Work& work) {
    program.require_subcommand(1);
    addPlayCommand(program, work);
    addEditCommand(program, work);
    addRunCommand(program, work);
    addVerifyCommand(program, work);
    addReportCommand(program, work);
    addSolveCommand(program, work);
    addComponentsCommand(program, work);
    addSchemaCommand(program, work);
    addAccuracyCommand(program, work);
    addScreenshotCommand(program, work);
    addClipCommand(program, work);
    addKeysCommand(program, work);
    addModCommand(program, work);
    addWhyCommand(program, work);
    refuseValuesOfFlags(program);
}

Request requestFrom(std::vector<std::string> const& arguments) {
    CLI::App program{about, "trembler"};
    program.set_version_flag("--version", "Trembler " TREMBLER_VERSION);
    Request request;
    addCommands(program, request.work);
    std::optional<std::string> refusal;
    try {
        // The parser takes them in reverse order.
        program.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
        refusal = refusalOf(program, arguments);
    } catch (CLI::Success const& help) {
        std::ostringstream out;
        std::ostringstream err;
        request.status = program.exit(help, out, err);
        request.out = out.str();
        request.err = err.str();
        return request;
    } catch (CLI::ParseError const& error) {
        refusal = refusalOf(program, arguments, error);
    } catch (std::exception const& error) {
        refusal = shown(error.what());
    }
    if (refusal) {
        request.work = {};
        request.err = "trembler: " + *refusal + "\n";
    }
    return request;
}

} // namespace trembler
