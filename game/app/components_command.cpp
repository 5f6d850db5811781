// trembler components and trembler schema: descriptions of all components and properties, and the components
// that each level's scene activates.
#include "game/app/commands.hpp"
#include "game/app/mods/mods.hpp"
#include "game/app/options/files/inputs.hpp"
#include "game/app/options/files/outputs.hpp"
#include "game/app/options/values/choice_option.hpp"
#include "measure/activation/report.hpp"
#include "puzzle/data/effects.hpp"
#include "puzzle/data/game_data.hpp"
#include "puzzle/data/published_schema.hpp"
#include "runtime/file/visible_text.hpp"
#include "runtime/notation/notation.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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
    std::vector<std::string> mods; // folders of mods whose interactions are printed, too
};

int describe(ComponentsArguments const& arguments) {
    Outputs outputs;
    std::vector<lua::Mod> mods = modsIn(arguments.mods);
    readsAll(outputs, mods);
    Registry registry;
    registerEffects(registry);
    registerModsIn(registry, mods);
    registry.check();
    std::optional<GameData> gameData; // the plays point into its registry
    if (arguments.levels) {
        gameData.emplace(std::move(mods));
        readsAll(outputs, *gameData);
    }
    OutputFile* const json = outputs.add("--json", arguments.json);
    OutputFile* const markdown = outputs.add("--markdown", arguments.markdown);
    std::vector<LevelUse> plays;
    if (gameData) {
        plays = playAllForCalls(*gameData, playSeconds);
    }
    if (json != nullptr) {
        json->stream() << printed(arguments.levels ? activationJson(plays) : notationJson(registry));
    }
    if (markdown != nullptr) {
        markdown->stream() << (arguments.levels ? activationMarkdown(plays) : notationMarkdown(registry));
    }
    outputs.finish();
    if (!outputs.terminalTaken()) {
        std::cout << (arguments.levels ? activationText(plays) : notationText(registry));
    }
    return exitSolved;
}

} // namespace

void addComponentsCommand(CLI::App& program, Work& work) {
    auto const arguments = std::make_shared<ComponentsArguments>();
    CLI::App* const command = program.add_subcommand(
        "components", "Print every component in the thesis's notation, and the schedule");
    addOptionalFile(*command, "--json", arguments->json, file_kinds::json,
                    "Write them as one JSON object; on the terminal it replaces the text");
    addOptionalFile(*command, "--markdown", arguments->markdown, file_kinds::markdown,
                    "Write them as Markdown tables; on the terminal they replace the text");
    command->add_flag("--levels", arguments->levels,
                      "Instead, for every level: which components are absent, asleep and active, "
                      "and their updates");
    addModFolderOption(
        *command, arguments->mods,
        "A mod's folder, or a folder of mods: their interactions, too. A level that does not name "
        "a mod has none of its interactions; with --levels they are all shown as absent");
    command->footer(outputConvention);
    command->callback([arguments, &work] { work = [arguments] { return describe(*arguments); }; });
}

void addSchemaCommand(CLI::App& program, Work& work) {
    auto const json = std::make_shared<OutputTarget>();
    auto const of = std::make_shared<std::string>(authoredFiles.front());
    CLI::App* const command =
        program.add_subcommand("schema", "Print the JSON Schema of a level file, a part or a chapter");
    addChoice(*command, "KIND", *of, {authoredFiles.begin(), authoredFiles.end()},
              "The kind of file: level, part or chapter (default: level)");
    addOptionalFile(*command, "--json", *json, file_kinds::json, "Write it to FILE (default: the terminal)");
    command->footer(outputConvention);
    command->callback([json, of, &work] {
        work = [json, of] {
            auto const kind = static_cast<AuthoredFile>(
                std::find(authoredFiles.begin(), authoredFiles.end(), *of) - authoredFiles.begin());
            Outputs outputs;
            OutputFile* const file = outputs.add("--json", *json);
            (file == nullptr ? std::cout : file->stream()) << printed(publishedSchema(kind));
            outputs.finish();
            return exitSolved;
        };
    });
}

} // namespace trembler
