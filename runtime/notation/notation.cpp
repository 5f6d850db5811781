#include "runtime/notation/notation.hpp"

#include "runtime/schedule/schedule.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace trembler {
namespace {

struct Row {
    std::string label;
    std::string text;
};

struct NotationBox {
    std::string title;
    std::vector<Row> rows;
    std::vector<CallInfo> const* calls = nullptr;
    ComponentInfo const* info = nullptr;
};

std::string set(std::vector<PropertyInfo const*> const& properties) {
    if (properties.empty()) {
        return "∅";
    }
    std::string text = "{";
    for (std::size_t i = 0; i < properties.size(); ++i) {
        text += (i == 0 ? "" : ", ") + std::string(properties[i]->text.name);
    }
    return text + "}";
}

std::string calledFor(ComponentInfo const& info) {
    std::string const demand = info.onDemand ? ", while somebody reads what it offers" : "";
    if (info.neededAll.empty() && info.neededAny.empty()) {
        return "every scene" + demand;
    }
    return (info.neededAny.empty() ? "objects with all of " + set(info.neededAll)
                                   : "objects with any of " + set(info.neededAny)) +
           demand;
}

std::string shortcutNote(Registry const& registry, ComponentInfo const& info) {
    std::string places;
    for (Shortcut const& shortcut : registry.shortcuts()) {
        for (Registration const& other : registry.components()) {
            if (shortcut.interaction == info.type && shortcut.dps == other.info->type) {
                places += (places.empty() ? "directly after the " : " or the ") + title(*other.info);
            }
        }
    }
    return places.empty() ? places : places + " (shortcut of 5.7.3)";
}

NotationBox boxOf(Registry const& registry, ComponentInfo const& info) {
    NotationBox box{title(info), {}, &info.calls, &info};
    switch (info.kind) {
    case ComponentKind::resolver:
        box.rows.push_back({"Resolver properties", set(info.offers)});
        box.rows.push_back({"Properties read", set(info.reads)});
        box.rows.push_back({"Properties written", info.writesEverything ? "everything" : set(info.writes)});
        box.rows.push_back({"Work on advance()", std::string(info.text.work)});
        break;
    case ComponentKind::dps:
        box.rows.push_back({"Properties read", set(info.reads)});
        box.rows.push_back({"Derived properties", set(info.offers)});
        box.rows.push_back({"Work on update()", std::string(info.text.work)});
        break;
    case ComponentKind::interaction:
        box.rows.push_back({"Properties read", set(info.reads)});
        box.rows.push_back({"Calls", std::string(info.roleName) + " Resolver"});
        box.rows.push_back({"Work on apply()", std::string(info.text.work)});
        if (std::string const note = shortcutNote(registry, info); !note.empty()) {
            box.rows.push_back({"Runs", note});
        }
        break;
    }
    if (!info.text.level.empty()) {
        box.rows.push_back({"Detail level", fmt::format("{} = {}", info.text.effect, info.text.level)});
    }
    box.rows.push_back({"Called for by", calledFor(info)});
    return box;
}

std::vector<ComponentInfo const*> resolversOf(Registry const& registry) {
    std::vector<ComponentInfo const*> all;
    for (Registration const& r : registry.components()) {
        if (r.info->kind == ComponentKind::resolver) {
            all.push_back(r.info);
        }
    }
    return all;
}

std::string reason(ComponentInfo const& a, ComponentInfo const& b) {
    std::string text;
    for (Conflict const& conflict : conflicts(a, b)) {
        std::string_view const property =
            conflict.property == nullptr ? "everything" : conflict.property->text.name;
        text += text.empty() ? "" : ", ";
        switch (conflict.kind) {
        case Conflict::Kind::bothWrite:
            text += fmt::format("both write {}", property);
            break;
        case Conflict::Kind::firstWritesRead:
            text += fmt::format("{} is written, then read", property);
            break;
        case Conflict::Kind::secondWritesRead:
            text += fmt::format("{} is read, then written", property);
            break;
        }
    }
    return text;
}

// Greedy line breaking at spaces; continuation lines are indented to the text.
std::string wrapped(std::string const& text, std::size_t indent, std::size_t width) {
    std::string out;
    std::size_t column = indent;
    std::size_t at = 0;
    while (at < text.size()) {
        std::size_t const end = std::min(text.find(' ', at), text.size());
        std::size_t const length = end - at;
        if (column > indent && column + 1 + length > width) {
            out += "\n" + std::string(indent, ' ');
            column = indent;
        } else if (column > indent) {
            out += ' ';
            ++column;
        }
        out.append(text, at, length);
        column += length;
        at = end + 1;
    }
    return out;
}

std::string signature(CallInfo const& call) {
    return fmt::format("{}{}", call.text.name, call.text.arguments);
}

std::string scheduleText(Registry const& registry, std::string_view bullet) {
    std::vector<ComponentInfo const*> const resolvers = resolversOf(registry);
    std::string text;
    for (std::size_t i = 0; i < resolvers.size(); ++i) {
        for (std::size_t j = i + 1; j < resolvers.size(); ++j) {
            if (areAlternatives(*resolvers[i], *resolvers[j])) {
                continue;
            }
            if (mayRunTogether(*resolvers[i], *resolvers[j])) {
                text += fmt::format("{}{} beside {}\n", bullet, title(*resolvers[i]), title(*resolvers[j]));
            } else {
                text += fmt::format("{}{} before {}: {}\n", bullet, title(*resolvers[i]),
                                    title(*resolvers[j]), reason(*resolvers[i], *resolvers[j]));
            }
        }
    }
    text += fmt::format("{}then all derived property sets beside one another\n", bullet);
    text += fmt::format("{}then all interactions beside one another\n", bullet);
    return text;
}

} // namespace

std::string notationBox(Registry const& registry, Registration const& component) {
    constexpr std::size_t width = 110;
    constexpr std::size_t labelWidth = 22;
    NotationBox const box = boxOf(registry, *component.info);
    std::string const line(width, '-');
    std::string text = line + "\n" + box.title + "\n" + line + "\n";
    for (Row const& row : box.rows) {
        text += fmt::format("{:<{}}{}\n", row.label + ":", labelWidth, wrapped(row.text, labelWidth, width));
    }
    if (!box.calls->empty()) {
        text += "Interaction functions:\n";
        for (CallInfo const& call : *box.calls) {
            std::string const head = fmt::format("  {} - ", signature(call));
            text += head +
                    wrapped(fmt::format("{} [{}]", call.text.meaning, nameOf(call.algebra)), 4, width - 30) +
                    "\n";
        }
    }
    return text + line + "\n";
}

std::string notationText(Registry const& registry) {
    std::string text;
    for (Registration const& component : registry.components()) {
        text += notationBox(registry, component) + "\n";
    }
    return text + "Schedule of a frame\n\n" + scheduleText(registry, "  ");
}

std::string notationMarkdown(Registry const& registry) {
    std::string text;
    auto const escaped = [](std::string s) {
        for (std::size_t at = 0; (at = s.find('|', at)) != std::string::npos; at += 2) {
            s.insert(at, "\\");
        }
        return s;
    };
    for (Registration const& component : registry.components()) {
        NotationBox const box = boxOf(registry, *component.info);
        text += fmt::format("### {}\n\n| | |\n|---|---|\n", box.title);
        for (Row const& row : box.rows) {
            text += fmt::format("| {} | {} |\n", row.label, escaped(row.text));
        }
        for (CallInfo const& call : *box.calls) {
            text += fmt::format("| `{}` | {} *{}* |\n", escaped(signature(call)),
                                escaped(std::string(call.text.meaning)), nameOf(call.algebra));
        }
        text += "\n";
    }
    return text + "## Schedule of a frame\n\n" + scheduleText(registry, "- ");
}

nlohmann::ordered_json notationJson(Registry const& registry) {
    using Json = nlohmann::ordered_json;
    auto const names = [](std::vector<PropertyInfo const*> const& list) {
        Json all = Json::array();
        for (PropertyInfo const* p : list) {
            all.push_back(p->text.name);
        }
        return all;
    };
    Json components = Json::array();
    for (Registration const& r : registry.components()) {
        ComponentInfo const& info = *r.info;
        Json calls = Json::array();
        for (CallInfo const& call : info.calls) {
            calls.push_back({{"name", call.text.name},
                             {"arguments", call.text.arguments},
                             {"meaning", call.text.meaning},
                             {"algebra", nameOf(call.algebra)}});
        }
        components.push_back({{"title", title(info)},
                              {"kind", nameOf(info.kind)},
                              {"effect", info.text.effect},
                              {"level", info.text.level},
                              {"role", info.roleName},
                              {"reads", names(info.reads)},
                              {"writes", info.writesEverything ? Json("everything") : names(info.writes)},
                              {"offers", names(info.offers)},
                              {"work", info.text.work},
                              {"calls", calls},
                              {"called_for", calledFor(info)},
                              {"shortcut", shortcutNote(registry, info)}});
    }
    Json edges = Json::array();
    Json together = Json::array();
    std::vector<ComponentInfo const*> const resolvers = resolversOf(registry);
    for (std::size_t i = 0; i < resolvers.size(); ++i) {
        for (std::size_t j = i + 1; j < resolvers.size(); ++j) {
            if (areAlternatives(*resolvers[i], *resolvers[j])) {
                continue;
            }
            Json pair{title(*resolvers[i]), title(*resolvers[j])};
            if (mayRunTogether(*resolvers[i], *resolvers[j])) {
                together.push_back(std::move(pair));
            } else {
                edges.push_back(
                    {{"before", pair[0]}, {"after", pair[1]}, {"why", reason(*resolvers[i], *resolvers[j])}});
            }
        }
    }
    return {{"components", components}, {"schedule", {{"edges", edges}, {"beside", together}}}};
}

} // namespace trembler
