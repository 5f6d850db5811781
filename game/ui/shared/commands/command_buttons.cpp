#include "game/ui/shared/commands/command_buttons.hpp"

#include "game/ui/shared/commands/named_keys.hpp"

#include <algorithm>

namespace trembler::ui {
namespace {

using namespace render;

std::string itemOf(CommandInfo const& info, CommandButtonOptions const& options) {
    std::string item(options.item.empty() ? info.id : options.item);
    std::replace(item.begin(), item.end(), '-', ' ');
    return item;
}

Icon iconOf(CommandInfo const& info, bool on) {
    return on && info.whenOn.icon != Icon::None ? info.whenOn.icon : info.icon;
}

} // namespace

std::string CommandButtons::tip(std::string_view id) const {
    std::size_t const index = commands_.indexOf(id);
    return tipOf(commands_.info(index), commands_.on(index), bindings_);
}

std::string CommandButtons::keyOf(std::string_view id) const {
    auto const keys = bindings_.keysOf(id);
    return keys.empty() ? std::string() : labelOf(keys.front());
}

void CommandButtons::note(bool clicked, std::size_t index, std::string item) {
    if (clicked) {
        asked_ = index;
    }
    layout_.item(std::move(item));
}

void CommandButtons::icon(std::string_view id, CommandButtonOptions const& options) {
    std::size_t const index = commands_.indexOf(id);
    CommandInfo const& info = commands_.info(index);
    bool const on = commands_.on(index);
    std::string const item = itemOf(info, options);
    bool const clicked =
        iconButton(item.c_str(), iconOf(info, on), tip(id).c_str(), on, commands_.available(index));
    note(clicked, index, item);
}

void CommandButtons::big(std::string_view id, CommandButtonOptions const& options) {
    std::size_t const index = commands_.indexOf(id);
    CommandInfo const& info = commands_.info(index);
    bool const on = commands_.on(index);
    char const* const name = on && info.whenOn.name != nullptr ? info.whenOn.name : info.name;
    std::string const label =
        std::string(options.label != nullptr ? options.label : name) + "##" + std::string(info.id);
    std::string const text = tip(id);
    bool const clicked = bigButton(label.c_str(), {.icon = options.withIcon ? iconOf(info, on) : Icon::None,
                                                   .look = options.look,
                                                   .width = options.width,
                                                   .enabled = commands_.available(index),
                                                   .tip = options.withTip ? text.c_str() : nullptr});
    note(clicked, index, itemOf(info, options));
}

} // namespace trembler::ui
