#include "game/ui/edit/commands/command_menus.hpp"
#include "game/ui/edit/commands/edit_actions.hpp"
#include "game/ui/edit/edit_parts.hpp"

namespace trembler::ui {
namespace {

using render::Icon;

constexpr Command<EditParts> editToolMenu[] = {
    {.info = {.id = "edit-select",
              .keys = {{{SDLK_1}, {SDLK_s}}},
              .group = CommandGroup::editing,
              .name = "Select",
              .tip = "Select, move, turn and scale",
              .help = "tools"},
     .run = actions::pick<Tool::select>,
     .on = actions::isTool<Tool::select>},
    {.info = {.id = "edit-box",
              .keys = {{{SDLK_2}, {SDLK_b}}},
              .group = CommandGroup::editing,
              .name = "Box",
              .tip = "Draw boxes: drag from corner to corner. Stays chosen; once more: one in the middle",
              .help = "tools"},
     .run = actions::pick<Tool::box>,
     .on = actions::isTool<Tool::box>},
    {.info = {.id = "edit-disc",
              .keys = {{{SDLK_3}, {SDLK_d}}},
              .group = CommandGroup::editing,
              .name = "Disc",
              .tip = "Draw discs: drag from the centre. Stays chosen; once more: one in the middle",
              .help = "tools"},
     .run = actions::pick<Tool::disc>,
     .on = actions::isTool<Tool::disc>},
    {.info = {.id = "edit-capsule",
              .keys = {{{SDLK_4}, {SDLK_c}}},
              .group = CommandGroup::editing,
              .name = "Capsule",
              .tip = "Draw capsules: drag from end to end. Stays chosen; once more: one in the middle",
              .help = "tools"},
     .run = actions::pick<Tool::capsule>,
     .on = actions::isTool<Tool::capsule>},
    {.info = {.id = "edit-polygon",
              .keys = {{{SDLK_5}, {SDLK_p}}},
              .group = CommandGroup::editing,
              .name = "Polygon",
              .tip = "Draw polygons: click the corners, the first one last. Stays chosen; once more: one in "
                     "the middle",
              .help = "tools"},
     .run = actions::pick<Tool::polygon>,
     .on = actions::isTool<Tool::polygon>},
    {.info = {.id = "edit-joint",
              .keys = {{{SDLK_6}, {SDLK_j}}},
              .group = CommandGroup::editing,
              .name = "Joint",
              .tip = "Join objects or pieces of parts: drag from one to the other, or to the paper. Stays "
                     "chosen; with two selected, once more joins them",
              .help = "tools"},
     .run = actions::pick<Tool::joint>,
     .on = actions::isTool<Tool::joint>},
    {.info = {.id = "edit-wire",
              .keys = {{{SDLK_7}, {SDLK_w}}},
              .icon = Icon::Bolt,
              .group = CommandGroup::editing,
              .name = "Wire",
              .tip = "Lay wires: drag from one conductor or pole to another, or click both. Stays chosen; "
                     "with two selected, once more connects them",
              .help = "tools"},
     .run = actions::pick<Tool::wire>,
     .on = actions::isTool<Tool::wire>},
    {.info = {.id = "edit-placing",
              .keys = {{{SDLK_8}, {SDLK_a}}},
              .group = CommandGroup::editing,
              .name = "Placing area",
              .tip = "Drag, or click the corners, where the player may place parts. Stays chosen; once more: "
                     "one in the middle",
              .help = "tools"},
     .run = actions::pick<Tool::placing>,
     .on = actions::isTool<Tool::placing>},
    {.info = {.id = "edit-goal-area",
              .keys = {{{SDLK_9}, {SDLK_t}}},
              .group = CommandGroup::editing,
              .name = "Goal area",
              .tip = "Drag, or click the corners, where the selected object is to come. Stays chosen; once "
                     "more: one in the middle",
              .help = "tools"},
     .run = actions::pick<Tool::goalArea>,
     .on = actions::isTool<Tool::goalArea>},
};

} // namespace

std::span<Command<EditParts> const> editToolCommands() {
    return editToolMenu;
}

} // namespace trembler::ui
