#include "runtime/notation/notation.hpp"

#include "runtime/notation/boxes.hpp"
#include "runtime/notation/state_coverage.hpp"
#include "runtime/notation/wrap_markdown.hpp"
#include "runtime/schedule/schedule.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <span>

namespace trembler {
namespace {

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
                text += fmt::format("{}{} in parallel with {}\n", bullet, title(*resolvers[i]),
                                    title(*resolvers[j]));
            } else {
                text += fmt::format("{}{} before {}: {}\n", bullet, title(*resolvers[i]),
                                    title(*resolvers[j]), reason(*resolvers[i], *resolvers[j]));
            }
        }
    }
    text += fmt::format("{}then all derived property sets, in parallel\n", bullet);
    text += fmt::format("{}then all interactions, in parallel\n", bullet);
    return text;
}

std::string boxText(NotationBox const& box) {
    constexpr std::size_t width = 110;
    constexpr std::size_t labelWidth = 22;
    std::string const line(width, '-');
    std::string text = line + "\n" + box.title + "\n" + line + "\n";
    for (NotationRow const& row : box.rows) {
        std::size_t const indent = row.label.empty() ? 0 : labelWidth;
        std::string const label = row.label.empty() ? "" : fmt::format("{:<{}}", row.label + ":", labelWidth);
        text += label + wrapped(row.text, indent, width) + "\n";
    }
    if (!box.calls.empty()) {
        text += "Interaction functions:\n";
        for (CallInfo const& call : box.calls) {
            std::string const head = fmt::format("  {} - ", signature(call));
            text += head +
                    wrapped(fmt::format("{} [{}]", call.text.meaning, nameOf(call.algebra)), 4, width - 30) +
                    "\n";
        }
    }
    return text + line + "\n";
}

std::string escaped(std::string s) {
    for (std::size_t at = 0; (at = s.find('|', at)) != std::string::npos; at += 2) {
        s.insert(at, "\\");
    }
    return s;
}

std::string boxMarkdown(NotationBox const& box) {
    std::string text = fmt::format("### {}\n\n", box.title);
    bool open = false;
    for (NotationRow const& row : box.rows) {
        if (row.label.empty()) {
            text += fmt::format("*{}*\n\n", row.text);
            continue;
        }
        text += open ? "" : "| | |\n|---|---|\n";
        open = true;
        text += fmt::format("| {} | {} |\n", row.label, escaped(row.text));
    }
    for (CallInfo const& call : box.calls) {
        text += fmt::format("| `{}` | {} *{}* |\n", escaped(signature(call)),
                            escaped(std::string(call.text.meaning)), nameOf(call.algebra));
    }
    return open ? text + "\n" : text;
}

std::string coverageText(Registry const& registry) {
    std::string text;
    for (CoverageLine const& line : stateCoverage(registry)) {
        text += "  " +
                wrapped(fmt::format("{}: {}{}", line.covered, line.what,
                                    line.reason.empty() ? "" : " (" + line.reason + ")"),
                        4, 110) +
                "\n";
    }
    return text;
}

std::string coverageMarkdown(Registry const& registry) {
    std::string text = "| | | |\n|---|---|---|\n";
    for (CoverageLine const& line : stateCoverage(registry)) {
        text += fmt::format("| {} | {} | {} |\n", line.covered, escaped(line.what), escaped(line.reason));
    }
    return text;
}

} // namespace

std::string notationBox(Registry const& registry, Registration const& component) {
    return boxText(boxOf(registry, *component.info));
}

std::string notationBox(CompletionInfo const& completion) {
    return boxText(boxOf(completion));
}

std::string notationBox(PropertyInfo const& property) {
    return boxText(boxOf(property));
}

std::string notationText(Registry const& registry) {
    std::string text;
    for (PropertyInfo const* property : registry.objectProperties()) {
        text += notationBox(*property) + "\n";
    }
    for (Registration const& component : registry.components()) {
        text += notationBox(registry, component) + "\n";
    }
    for (CompletionInfo const* completion : completionOrder(registry.completions())) {
        text += notationBox(*completion) + "\n";
    }
    return text + "Schedule of a frame\n\n" + scheduleText(registry, "  ") +
           "\nWhat the state hash covers\n\n" + coverageText(registry);
}

std::string notationMarkdown(Registry const& registry) {
    std::string text = "## Components\n\n";
    for (Registration const& component : registry.components()) {
        text += boxMarkdown(boxOf(registry, *component.info));
    }
    text +=
        "## Properties\n\nObject properties. Resolver and derived properties are listed with the component "
        "that provides them. Units are those of the program; in files, values whose key ends in _deg are in "
        "degrees.\n\n";
    for (PropertyInfo const* property : registry.objectProperties()) {
        text += boxMarkdown(boxOf(*property));
    }
    text += "## Completions\n\nCompletions add properties to a new object, in this order. They do not change "
            "stated properties.\n\n";
    for (CompletionInfo const* completion : completionOrder(registry.completions())) {
        text += boxMarkdown(boxOf(*completion));
    }
    return wrapMarkdown(
        text + "## Schedule of a frame\n\n" + scheduleText(registry, "- ") +
        "\n## What the state hash covers\n\nEqual hashes mean equal worlds and equal futures. *Derived* "
        "data are recomputed from hashed data in each turn of the component that provides them; they are "
        "hashed if this component has a period.\n\n" +
        coverageMarkdown(registry));
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
                              {"reads", info.writesEverything ? Json("everything") : names(allRead(info))},
                              {"writes", info.writesEverything ? Json("everything") : names(info.writes)},
                              {"offers", names(info.offers)},
                              {"work", info.text.work},
                              {"calls", calls},
                              {"activated_by", activation(info)},
                              {"shortcut", shortcutNote(registry, info)},
                              {"in_setup", info.inSetup}});
    }
    Json completions = Json::array();
    for (CompletionInfo const* info : completionOrder(registry.completions())) {
        completions.push_back({{"title", title(*info)},
                               {"reads", names(info->reads)},
                               {"adds", names(info->adds)},
                               {"work", info->text.work},
                               {"activated_by", boxOf(*info).rows.back().text}});
    }
    Json properties = Json::array();
    for (PropertyInfo const* info : registry.objectProperties()) {
        properties.push_back(
            {{"name", info->text.name}, {"key", info->text.key}, {"meaning", info->text.meaning}});
    }
    Json covered = Json::array();
    for (CoverageLine const& line : stateCoverage(registry)) {
        covered.push_back({{"what", line.what}, {"covered", line.covered}, {"reason", line.reason}});
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
    return {{"components", components},
            {"properties", properties},
            {"completions", completions},
            {"schedule", {{"edges", edges}, {"beside", together}}},
            {"state_hash", covered}};
}

} // namespace trembler
