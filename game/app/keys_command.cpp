// trembler keys: lists every command of the window with its keys, and what the mouse does; docs/players.md is
// made from these lists.
#include "game/app/commands.hpp"
#include "game/app/outputs.hpp"

#ifndef TREMBLER_HEADLESS
#include "game/ui/app/command_lists.hpp"
#include "game/ui/commands/key_help.hpp"
#endif

#include <iostream>
#include <memory>
#include <stdexcept>

namespace trembler {
namespace {

struct KeysArguments {
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
    OutputFile* const markdown = outputs.add("--markdown", arguments.markdown);
    OutputFile* const mouse = outputs.add("--mouse", arguments.mouse);
    ui::KeyBindings const bindings(ui::commandLists());
    if (markdown != nullptr) {
        markdown->stream() << ui::keysMarkdown(bindings);
    }
    if (mouse != nullptr) {
        mouse->stream() << ui::gesturesMarkdown(ui::allGestures());
    }
    if (markdown == nullptr && mouse == nullptr) {
        std::cout << ui::keysText(bindings);
    }
    outputs.finish();
    return exitSolved;
}

#endif

} // namespace

void addKeysCommand(CLI::App& program, int& result) {
    auto const arguments = std::make_shared<KeysArguments>();
    CLI::App* const command =
        program.add_subcommand("keys", "Print what can be done in the window, and the usual keys for it");
    addOptionalFile(*command, "--markdown", arguments->markdown, "Write them as Markdown tables instead");
    addOptionalFile(*command, "--mouse", arguments->mouse,
                    "Write what the mouse does as Markdown tables instead");
    command->footer(outputConvention);
    command->callback([arguments, &result] { result = guarded([&] { return printKeys(*arguments); }); });
}

} // namespace trembler
