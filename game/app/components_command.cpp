// trembler components and trembler schema: what there is, described by itself, and what levels call for.
#include "game/app/commands.hpp"
#include "game/called_for/report.hpp"
#include "game/core/effects.hpp"
#include "game/core/workshop.hpp"
#include "game/goals/level_schema.hpp"
#include "runtime/notation/notation.hpp"

#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>

namespace trembler {
namespace {

constexpr int playSeconds = 20; // long enough for all that comes to rest, but for a motor that runs out

void printLevels(bool json, bool markdown) {
    Workshop const workshop;
    std::vector<LevelUse> const plays = playAllForCalls(workshop, playSeconds);
    if (json) {
        std::cout << calledForJson(plays).dump(2) << "\n";
    } else {
        std::cout << (markdown ? calledForMarkdown(plays) : calledForText(plays));
    }
}

} // namespace

void addComponentsCommand(CLI::App& program, int& result) {
    struct Arguments {
        bool json = false;
        bool markdown = false;
        bool levels = false;
    };
    auto const arguments = std::make_shared<Arguments>();
    CLI::App* const command = program.add_subcommand(
        "components", "Print every component in the thesis's notation, and the schedule");
    CLI::Option* const json = command->add_flag("--json", arguments->json, "As one JSON object");
    command->add_flag("--markdown", arguments->markdown, "As Markdown tables")->excludes(json);
    command->add_flag("--levels", arguments->levels,
                      "What every level calls for instead: which components are absent, asleep and active, "
                      "and their updates");
    command->callback([arguments, &result] {
        result = guarded([&] {
            Registry registry;
            registerEffects(registry);
            registry.check();
            for (std::string const& effect : gameEffectsLeftOut()) {
                std::cerr << "This program was built without " << effect
                          << ": only its properties are known.\n";
            }
            if (arguments->levels) {
                printLevels(arguments->json, arguments->markdown);
            } else if (arguments->json) {
                std::cout << notationJson(registry).dump(2) << "\n";
            } else {
                std::cout << (arguments->markdown ? notationMarkdown(registry) : notationText(registry));
            }
            return exitSolved;
        });
    });
}

void addSchemaCommand(CLI::App& program, int& result) {
    CLI::App* const command = program.add_subcommand("schema", "Print the JSON Schema of a level file");
    command->callback([&result] {
        result = guarded([&] {
            Registry registry;
            registerEffects(registry);
            std::cout << levelSchema(registry).dump(2) << "\n";
            return exitSolved;
        });
    });
}

} // namespace trembler
