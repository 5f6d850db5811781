// trembler keys: lists every command of the window with its keys, and the mouse's gestures; docs/players.md
// is made from these lists.
#include "game/app/commands.hpp"
#include "game/app/options/files/outputs.hpp"

#ifndef TREMBLER_HEADLESS
#include "game/ui/app/command_lists.hpp"
#include "game/ui/shared/commands/key_help.hpp"
#include "runtime/file/visible_text.hpp"

#include <nlohmann/json.hpp>
#endif

#include <iostream>
#include <memory>
#include <stdexcept>

namespace trembler {
namespace {

struct KeysArguments {
    OutputTarget json;
    OutputTarget markdown;
    OutputTarget mouse;
};

#ifdef TREMBLER_HEADLESS

int printKeys(KeysArguments const&) {
    throw std::runtime_error(
        "this build was made without the window; build it without -DTREMBLER_HEADLESS=ON");
}

#else

int printKeys(KeysArguments const& arguments) {
    Outputs outputs;
    OutputFile* const json = outputs.add("--json", arguments.json);
    OutputFile* const markdown = outputs.add("--markdown", arguments.markdown);
    OutputFile* const mouse = outputs.add("--mouse", arguments.mouse);
    ui::KeyBindings const bindings(ui::commandLists());
    if (json != nullptr) {
        json->stream() << escapedJson(ui::keysJson(bindings).dump(2)) << "\n";
    }
    if (markdown != nullptr) {
        markdown->stream() << ui::keysMarkdown(bindings);
    }
    if (mouse != nullptr) {
        mouse->stream() << ui::gesturesMarkdown(ui::allGestures());
    }
    outputs.finish();
    if (!outputs.terminalTaken()) {
        std::cout << ui::keysText(bindings);
    }
    return exitSolved;
}

#endif

} // namespace

void addKeysCommand(CLI::App& program, Work& work) {
    auto const arguments = std::make_shared<KeysArguments>();
    CLI::App* const command =
        program.add_subcommand("keys", "Print the commands of the window and their default keys");
    addOptionalFile(*command, "--json", arguments->json, file_kinds::json,
                    "Write them as one JSON object; on the terminal it replaces the text");
    addOptionalFile(*command, "--markdown", arguments->markdown, file_kinds::markdown,
                    "Write them as Markdown tables; on the terminal they replace the text");
    addOptionalFile(*command, "--mouse", arguments->mouse, file_kinds::markdown,
                    "Write the mouse gestures as Markdown tables; on the terminal they replace the text");
    command->footer(outputConvention);
    command->callback([arguments, &work] { work = [arguments] { return printKeys(*arguments); }; });
}

} // namespace trembler
