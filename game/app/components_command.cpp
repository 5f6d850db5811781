// trembler components and trembler schema: descriptions of all components and properties, and the components
// that each level's scene activates.
#include "game/app/commands.hpp"
#include "game/app/outputs.hpp"
#include "measure/activation/report.hpp"
#include "puzzle/data/effects.hpp"
#include "puzzle/data/game_data.hpp"
#include "puzzle/goals/level_schema.hpp"
#include "runtime/file/visible_text.hpp"
#include "runtime/notation/notation.hpp"

#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>

namespace trembler {
namespace {

/// Long enough for every level to come to rest, except for a motor that runs down.
constexpr int playSeconds = 20;

std::string printed(nlohmann::ordered_json const& json) {
    return escapedJson(json.dump(2)) + "\n";
}

struct ComponentsArguments {
    OutputTarget json;
    OutputTarget markdown;
    bool levels = false;
};

int describe(ComponentsArguments const& arguments) {
    Outputs outputs;
    OutputFile* const json = outputs.add("--json", arguments.json);
    OutputFile* const markdown = outputs.add("--markdown", arguments.markdown);
    Registry registry;
    registerEffects(registry);
    registry.check();
    std::vector<LevelUse> plays;
    if (arguments.levels) {
        GameData const gameData;
        plays = playAllForCalls(gameData, playSeconds);
    }
    if (json != nullptr) {
        json->stream() << printed(arguments.levels ? activationJson(plays) : notationJson(registry));
    }
    if (markdown != nullptr) {
        markdown->stream() << (arguments.levels ? activationMarkdown(plays) : notationMarkdown(registry));
    }
    if (json == nullptr && markdown == nullptr) {
        std::cout << (arguments.levels ? activationText(plays) : notationText(registry));
    }
    outputs.finish();
    return exitSolved;
}

} // namespace

void addComponentsCommand(CLI::App& program, int& result) {
    auto const arguments = std::make_shared<ComponentsArguments>();
    CLI::App* const command = program.add_subcommand(
        "components", "Print every component in the thesis's notation, and the schedule");
    addOptionalFile(*command, "--json", arguments->json, "Write them as one JSON object instead");
    addOptionalFile(*command, "--markdown", arguments->markdown, "Write them as Markdown tables instead");
    command->add_flag("--levels", arguments->levels,
                      "What every level activates instead: which components are absent, asleep and active, "
                      "and their updates");
    command->footer(outputConvention);
    command->callback([arguments, &result] { result = guarded([&] { return describe(*arguments); }); });
}

void addSchemaCommand(CLI::App& program, int& result) {
    CLI::App* const command = program.add_subcommand("schema", "Print the JSON Schema of a level file");
    command->callback([&result] {
        result = guarded([&] {
            Registry registry;
            registerEffects(registry);
            std::cout << printed(levelSchema(registry));
            return exitSolved;
        });
    });
}

} // namespace trembler
