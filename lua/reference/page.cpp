#include "lua/reference/page.hpp"

#include "lua/reference/globals.hpp"
#include "runtime/component/call.hpp"
#include "runtime/notation/wrap_markdown.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace trembler::lua {
namespace {

std::string cell(std::string_view text) {
    std::string all;
    for (char const c : text) {
        all += c == '|' ? std::string("\\|") : std::string(1, c);
    }
    return all;
}

std::string joined(std::vector<std::string> const& words, std::string_view between) {
    std::string all;
    for (std::string const& word : words) {
        all += (all.empty() ? "" : std::string(between)) + word;
    }
    return all;
}

/// A row for a field, and one for each field of its entries.
void addRows(std::string& text, ReferenceField const& field, std::string const& prefix) {
    std::string const name = prefix + std::string(field.info.key);
    bool const listOfValues =
        field.kind == FieldKind::list && !field.entriesHaveFields && !field.entry.empty();
    std::string const kind =
        listOfValues ? fmt::format("list of {}", kindText(field.entry.front())) : kindText(field);
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", name, kind, field.info.unit,
                        rangeText(listOfValues ? field.entry.front() : field), cell(field.info.meaning));
    if (field.entriesHaveFields) {
        for (ReferenceField const& part : field.entry) {
            addRows(text, part, name + "[i].");
        }
    }
}

std::string homeText(ReferenceProperty const& property) {
    switch (property.home) {
    case PropertyHome::objects:
        return "of objects";
    case PropertyHome::world:
        return "of the world; nil where a level does not state it";
    case PropertyHome::state:
        break;
    }
    return "computed by " + joined(property.offeredBy, ", ");
}

std::string propertyMarkdown(ReferenceProperty const& property) {
    PropertyText const& text = property.info->text;
    std::string all = fmt::format("### {}\n\n`{}`, in files `{}`; {}. {}\n\n", text.name,
                                  expressionOf(property), text.key, homeText(property), cell(text.meaning));
    if (!property.fields.empty()) {
        all += "| field | type | unit | range | meaning |\n|---|---|---|---|---|\n";
        for (ReferenceField const& field : property.fields) {
            addRows(all, field, "");
        }
        all += "\n";
    }
    return all + fmt::format("```lua\n{}```\n\n", property.body);
}

std::string signature(ReferenceFunction const& function) {
    std::string arguments;
    for (ReferenceField const& argument : function.arguments) {
        arguments += fmt::format("{}{}", arguments.empty() ? "" : ", ", argument.info.key);
    }
    return fmt::format("out.{}({})", function.call->text.name, arguments);
}

std::string functionMarkdown(ReferenceFunction const& function) {
    std::string all =
        fmt::format("### {}\n\n`{}`. {} *{}*\n\n", function.call->text.name, signature(function),
                    cell(function.call->text.meaning), nameOf(function.call->algebra));
    all += "| argument | type | unit | range | if left out | meaning |\n|---|---|---|---|---|---|\n";
    for (ReferenceField const& argument : function.arguments) {
        all += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", argument.info.key, kindText(argument),
                           argument.info.unit, rangeText(argument), argument.initial,
                           cell(argument.info.meaning));
    }
    return all + fmt::format("\n```lua\n{}```\n\n", function.example);
}

nlohmann::ordered_json jsonOf(ReferenceField const& field) {
    nlohmann::ordered_json all{{"key", field.info.key},
                               {"type", kindText(field)},
                               {"unit", field.info.unit},
                               {"range", rangeText(field)},
                               {"meaning", field.info.meaning}};
    if (!field.initial.empty()) {
        all["initial"] = field.initial;
    }
    for (ReferenceField const& part : field.entry) {
        all["entry"].push_back(jsonOf(part));
    }
    return all;
}

} // namespace

std::string referenceMarkdown(Reference const& reference) {
    std::string all = "## What every script has\n\n| | | |\n|---|---|---|\n";
    for (GlobalNote const& note : globalNotes()) {
        all += fmt::format("| `{}` | {} | `{}` |\n", note.use, cell(note.meaning), cell(note.example));
    }
    all += "\n";
    RoleInfo const* role = nullptr;
    for (ReferenceFunction const& function : reference.functions) {
        if (function.role != role) {
            role = function.role;
            all += fmt::format("## Functions of {}\n\n", role->name);
        }
        all += functionMarkdown(function);
    }
    bool ofObjects = false;
    bool others = false;
    for (ReferenceProperty const& property : reference.properties) {
        bool& begun = property.home == PropertyHome::objects ? ofObjects : others;
        if (!begun) {
            begun = true;
            all += &begun == &ofObjects ? "## Properties of objects\n\n"
                                        : "## Properties of the world and of its simulations\n\n";
        }
        all += propertyMarkdown(property);
    }
    all.pop_back(); // of the empty line at the end
    return wrapMarkdown(all);
}

std::string referenceText(Reference const& reference) {
    std::string all;
    for (GlobalNote const& note : globalNotes()) {
        all += fmt::format("{:34} {}\n", note.use, note.meaning);
    }
    for (ReferenceFunction const& function : reference.functions) {
        all += fmt::format("\n{}: {}\n    {}\n", function.role->name, signature(function),
                           function.call->text.meaning);
        for (ReferenceField const& argument : function.arguments) {
            all += fmt::format("    {:14} {} {} {}: {}\n", argument.info.key, kindText(argument),
                               argument.info.unit, rangeText(argument), argument.info.meaning);
        }
    }
    for (ReferenceProperty const& property : reference.properties) {
        all += fmt::format("\n{}\n    {}\n", expressionOf(property), property.info->text.meaning);
        for (ReferenceField const& field : property.fields) {
            all += fmt::format("    {:14} {} {} {}: {}\n", field.info.key, kindText(field), field.info.unit,
                               rangeText(field), field.info.meaning);
        }
    }
    return all;
}

nlohmann::ordered_json referenceJson(Reference const& reference) {
    using Json = nlohmann::ordered_json;
    Json globals = Json::array();
    for (GlobalNote const& note : globalNotes()) {
        globals.push_back(
            {{"name", note.name}, {"use", note.use}, {"meaning", note.meaning}, {"example", note.example}});
    }
    Json functions = Json::array();
    for (ReferenceFunction const& function : reference.functions) {
        Json arguments = Json::array();
        for (ReferenceField const& argument : function.arguments) {
            arguments.push_back(jsonOf(argument));
        }
        functions.push_back({{"resolver", function.role->name},
                             {"name", function.call->text.name},
                             {"meaning", function.call->text.meaning},
                             {"algebra", nameOf(function.call->algebra)},
                             {"held", isHeld(function.call->algebra)},
                             {"arguments", arguments},
                             {"example", function.example}});
    }
    Json properties = Json::array();
    for (ReferenceProperty const& property : reference.properties) {
        Json fields = Json::array();
        for (ReferenceField const& field : property.fields) {
            fields.push_back(jsonOf(field));
        }
        properties.push_back({{"name", property.info->text.name},
                              {"key", property.info->text.key},
                              {"expression", expressionOf(property)},
                              {"of", property.home == PropertyHome::objects ? "objects"
                                     : property.home == PropertyHome::world ? "world"
                                                                            : "simulations"},
                              {"offered_by", property.offeredBy},
                              {"meaning", property.info->text.meaning},
                              {"fields", fields},
                              {"example", property.example}});
    }
    return {{"globals", globals}, {"functions", functions}, {"properties", properties}};
}

} // namespace trembler::lua
