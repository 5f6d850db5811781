// trembler mod reference, trembler mod annotations.
#include "game/app/mods/mod_reference_command.hpp"

#include "game/app/commands.hpp"
#include "game/app/options/files/file_rules.hpp"
#include "game/app/options/files/outputs.hpp"
#include "lua/reference/annotations.hpp"
#include "lua/reference/page.hpp"
#include "puzzle/data/effects.hpp"
#include "runtime/file/output_file.hpp"
#include "runtime/file/visible_text.hpp"
#include "runtime/world/registry.hpp"

#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>

namespace trembler {
namespace {

struct ReferenceArguments {
    OutputTarget json;
    OutputTarget markdown;
    std::string folder;
};

int printReference(ReferenceArguments const& arguments) {
    Outputs outputs;
    OutputFile* const json = outputs.add("--json", arguments.json);
    OutputFile* const markdown = outputs.add("--markdown", arguments.markdown);
    Registry registry;
    registerEffects(registry);
    lua::Reference const reference = lua::makeReference(registry);
    if (json != nullptr) {
        json->stream() << escapedJson(lua::referenceJson(reference).dump(2)) << "\n";
    }
    if (markdown != nullptr) {
        markdown->stream() << lua::referenceMarkdown(reference);
    }
    outputs.finish();
    if (!outputs.terminalTaken()) {
        std::cout << lua::referenceText(reference);
    }
    return exitSolved;
}

void writeAnnotationsInto(std::filesystem::path const& folder) {
    Registry registry;
    registerEffects(registry);
    lua::writeAnnotations(folder, lua::makeReference(registry));
}

} // namespace

void writeEditorFiles(std::filesystem::path const& mod) {
    writeAnnotationsInto(mod / "annotations");
    writeFile(mod / ".luarc.json", lua::editorSettings());
}

void addModReferenceCommands(CLI::App& mod, Work& work) {
    auto const arguments = std::make_shared<ReferenceArguments>();
    CLI::App* const reference = mod.add_subcommand(
        "reference", "Print every property that scripts can read and every function that they can call");
    addOptionalFile(*reference, "--json", arguments->json, file_kinds::json,
                    "Write them as one JSON object, with examples; on the terminal it replaces the text");
    addOptionalFile(*reference, "--markdown", arguments->markdown, file_kinds::markdown,
                    "Write them as Markdown, with examples; on the terminal it replaces the text");
    reference->footer(outputConvention);
    reference->callback([arguments, &work] { work = [arguments] { return printReference(*arguments); }; });
    CLI::App* const annotations = mod.add_subcommand(
        "annotations", "Write trembler.lua, by which editors with the Lua Language Server complete names");
    accepts(annotations->add_option("DIR", arguments->folder, "The folder to write it into")
                ->required()
                ->type_name(""),
            "a folder, which is made if it is missing", faultOfOutputFolder);
    annotations->callback([arguments, &work] {
        work = [arguments] {
            writeAnnotationsInto(arguments->folder);
            std::cout << visible((std::filesystem::path(arguments->folder) / "trembler.lua").string())
                      << ": written\n";
            return exitSolved;
        };
    });
}

} // namespace trembler
