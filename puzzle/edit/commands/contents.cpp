#include "puzzle/edit/commands/contents.hpp"

#include "puzzle/edit/commands/translations.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "runtime/level/json/limits.hpp"
#include "runtime/level/model/tool_count.hpp"
#include "runtime/level/write/write_level.hpp"

#include <fmt/format.h>

#include <optional>

namespace trembler::edit {
namespace {

void mustBeCount(int count) {
    if ((count < 1 || count > limits::toolboxCount) && count != unlimitedCount) {
        throw CommandError(fmt::format("a toolbox has 1 to {} of a part", limits::toolboxCount));
    }
}

/// Removes an entry of a list; `keepEmpty`: the list means something without entries.
Command removeEntry(Json const& level, char const* key, std::size_t index, std::string_view what,
                    bool keepEmpty = false) {
    mustHaveEntry(level, key, index, what);
    return {fmt::format("Remove {}", what), [key, index, keepEmpty](Json& tree) {
                mustHaveEntry(tree, key, index, "entry");
                tree[key].erase(index);
                if (!keepEmpty) {
                    dropIfEmpty(tree, key);
                }
            }};
}

Command moveListEntry(Json const& level, char const* key, std::size_t from, std::size_t to,
                      std::string_view what) {
    mustHaveEntry(level, key, from, what);
    mustHaveEntry(level, key, to, what);
    return {fmt::format("Move {}", what), [=](Json& tree) { moveEntry(tree, key, from, to); }};
}

} // namespace

Command setTitle(Json const& /*level*/, std::string const& title) {
    mustBeName(title, "the title");
    return {"Change title", [title](Json& tree) { setLevelMember(tree, "title", title); }};
}

Command setText(Json const& /*level*/, std::string const& text) {
    return {"Change text", [text](Json& tree) {
                if (text.empty()) {
                    tree.erase("text");
                } else {
                    setLevelMember(tree, "text", text);
                }
            }};
}

Command setDemonstration(Json const& /*level*/, bool demonstration) {
    return {demonstration ? "Make it a demonstration" : "Make it no demonstration",
            [demonstration](Json& tree) {
                if (demonstration) {
                    setLevelMember(tree, "demonstration", true);
                } else {
                    tree.erase("demonstration");
                }
            }};
}

Command setMods(Json const& /*level*/, std::vector<std::string> const& mods) {
    for (std::string const& mod : mods) {
        mustBeName(mod, "the name of a mod");
    }
    return {"Change mods", [mods](Json& tree) {
                if (mods.empty()) {
                    tree.erase("mods");
                } else {
                    setLevelMember(tree, "mods", mods);
                }
            }};
}

Command addHint(Json const& /*level*/, std::string const& hint) {
    return {"Add hint", [hint](Json& tree) {
                listIn(tree, "hints").push_back(hint);
                translationsGotHint(tree, hint);
            }};
}

Command setHint(Json const& level, std::size_t index, std::string const& hint) {
    mustHaveEntry(level, "hints", index, "hint");
    return {"Change hint", [=](Json& tree) {
                Json& entry = entryIn(tree, "hints", index);
                translationsChangedHint(tree, index, entry, hint);
                entryIn(tree, "hints", index) = hint;
            }};
}

Command removeHint(Json const& level, std::size_t index) {
    Command command = removeEntry(level, "hints", index, "hint");
    command.change = [own = std::move(command.change), index](Json& tree) {
        own(tree);
        translationsLostHint(tree, index);
    };
    return command;
}

Command moveHint(Json const& level, std::size_t from, std::size_t to) {
    Command command = moveListEntry(level, "hints", from, to, "hint");
    command.change = [own = std::move(command.change), from, to](Json& tree) {
        own(tree);
        translationsMovedHint(tree, from, to);
    };
    return command;
}

Command addTool(Json const& level, std::string const& part, int count) {
    mustBeName(part, "the name of a part");
    mustBeCount(count);
    Json const* const list = findList(level, "toolbox");
    for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
        if (textOf((*list)[i], "part") == part) {
            auto const stated = (*list)[i].find("count");
            bool const unlimited = stated != (*list)[i].end() && *stated == unlimitedWord;
            double const before = stated == (*list)[i].end() ? 1 : unlimited ? 0 : numberOf(*stated);
            if (count != unlimitedCount && before + count > static_cast<double>(limits::toolboxCount)) {
                mustBeCount(static_cast<int>(limits::toolboxCount) + 1);
            }
            bool const any = unlimited || count == unlimitedCount;
            Command more = setToolCount(level, i, any ? unlimitedCount : static_cast<int>(before) + count);
            more.name = fmt::format("Add {} to the toolbox", part);
            return more;
        }
    }
    return {fmt::format("Add {} to the toolbox", part), [=](Json& tree) {
                listIn(tree, "toolbox").push_back(Json{{"part", part}, {"count", countJson(count)}});
            }};
}

Command setToolCount(Json const& level, std::size_t index, int count) {
    mustHaveEntry(level, "toolbox", index, "part");
    mustBeCount(count);
    return {"Change count", [=](Json& tree) { entryIn(tree, "toolbox", index)["count"] = countJson(count); }};
}

Command setWires(Json const& /*level*/, int count) {
    if (count != 0) {
        mustBeCount(count);
    }
    return {"Change number of wires", [count](Json& tree) {
                // Sought here: a later change of a drag is made to the tree as it was before the drag.
                Json& tools = listIn(tree, "toolbox");
                std::optional<std::size_t> stated;
                for (std::size_t i = 0; i < tools.size(); ++i) {
                    if (tools[i].is_object() && tools[i].contains("wire")) {
                        stated = i;
                    }
                }
                if (!stated && count > 0) {
                    tools.push_back(Json{{"wire", countJson(count)}});
                } else if (stated && count > 0) {
                    tools[*stated]["wire"] = countJson(count);
                } else if (stated) {
                    tools.erase(*stated);
                }
                dropIfEmpty(tree, "toolbox");
            }};
}

std::optional<Json> newStep(std::string const& kind, std::vector<std::string> const& names, Vec2 at) {
    std::size_t const needed = kind == "run" ? 0 : kind == "wire" || kind == "cut" ? 2 : 1;
    if (names.size() < needed) {
        return std::nullopt;
    }
    if (kind == "run") {
        return Json{{"run", true}};
    }
    if (needed == 2) {
        return Json{{kind, {names[0], names[1]}}};
    }
    return Json{{kind, names[0]}, {kind == "place" ? "at" : "to", pointJson(at)}};
}

Command addStep(Json const& /*level*/, Json const& step) {
    return {"Add step", [step](Json& tree) { listIn(tree, "teaching").push_back(step); }};
}

Command setStep(Json const& level, std::size_t index, Json const& step) {
    mustHaveEntry(level, "teaching", index, "step");
    return {"Change step", [=](Json& tree) { entryIn(tree, "teaching", index) = step; }};
}

Command removeStep(Json const& level, std::size_t index) {
    return removeEntry(level, "teaching", index, "step");
}

Command moveStep(Json const& level, std::size_t from, std::size_t to) {
    return moveListEntry(level, "teaching", from, to, "step");
}

Command removeTool(Json const& level, std::size_t index) {
    return removeEntry(level, "toolbox", index, "part from the toolbox");
}

Command moveTool(Json const& level, std::size_t from, std::size_t to) {
    return moveListEntry(level, "toolbox", from, to, "part in the toolbox");
}

Json areaJson(Area const& area) {
    if (area.box) {
        return Json::array({numberJson(area.box->corner.x), numberJson(area.box->corner.y),
                            numberJson(area.box->size.x), numberJson(area.box->size.y)});
    }
    Json corners = Json::array();
    for (Vec2 const corner : area.corners) {
        corners.push_back(pointJson(corner));
    }
    return corners;
}

Command addPlacingArea(Json const& /*level*/, Area const& area) {
    Json const made = areaJson(area);
    return {"Add area for placing", [made](Json& tree) { listIn(tree, "placing").push_back(made); }};
}

Command setPlacingArea(Json const& level, std::size_t index, Area const& area) {
    mustHaveEntry(level, "placing", index, "area");
    return {"Change area for placing",
            [index, made = areaJson(area)](Json& tree) { entryIn(tree, "placing", index) = made; }};
}

Command removePlacingArea(Json const& level, std::size_t index) {
    return removeEntry(level, "placing", index, "area for placing", true);
}

Command placeAnywhere(Json const& /*level*/) {
    return {"Allow placing anywhere", [](Json& tree) { tree.erase("placing"); }};
}

} // namespace trembler::edit
