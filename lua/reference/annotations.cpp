#include "lua/reference/annotations.hpp"

#include "lua/reference/globals.hpp"
#include "runtime/file/folders.hpp"
#include "runtime/file/output_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace trembler::lua {
namespace {

std::string className(std::string_view key) {
    std::string name = "trembler.";
    for (char const c : key) {
        bool const good = static_cast<unsigned char>(c) < 0x80 &&
                          (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.');
        name += good ? c : '_';
    }
    return name;
}

/// A field's name in an annotation: a keyword of Lua is put in brackets.
std::string fieldName(std::string_view key) {
    std::string const member = memberOf("", key);
    return member.front() == '.' ? member.substr(1) : member;
}

/// The text about a field, in one line: an annotation ends with it.
std::string note(ReferenceField const& field) {
    std::string const range = rangeText(field);
    std::string text =
        fmt::format("{}{}{}", field.info.unit, field.info.unit.empty() || range.empty() ? "" : ", ", range);
    text += fmt::format("{}{}", text.empty() || field.info.meaning.empty() ? "" : ": ", field.info.meaning);
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

std::string typeName(ReferenceField const& field, std::string const& entryClass) {
    switch (field.kind) {
    case FieldKind::boolean:
        return "boolean";
    case FieldKind::integer:
    case FieldKind::whole:
        return "integer";
    case FieldKind::number:
        return "number";
    case FieldKind::vector:
        return "vec2";
    case FieldKind::text:
    case FieldKind::part:
        return "string";
    case FieldKind::object:
        return "trembler.Object";
    case FieldKind::choice: {
        std::string all;
        for (std::string const& choice : field.choices) {
            all += fmt::format("{}\"{}\"", all.empty() ? "" : "|", choice);
        }
        return all;
    }
    case FieldKind::list:
        break;
    }
    if (field.entriesHaveFields) {
        return entryClass + "[]";
    }
    return field.entry.empty() ? "any[]" : typeName(field.entry.front(), entryClass) + "[]";
}

/// The class of a property or of an entry, after those of its entries.
void addClass(std::string& text, std::string const& name, std::string_view meaning,
              std::vector<ReferenceField> const& fields) {
    for (ReferenceField const& field : fields) {
        if (field.entriesHaveFields) {
            addClass(text, fmt::format("{}.{}", name, field.info.key), field.info.meaning, field.entry);
        }
    }
    text += fmt::format("--- {}\n---@class {}\n", meaning, name);
    for (ReferenceField const& field : fields) {
        bool const optional = field.kind == FieldKind::object;
        text += fmt::format("---@field {}{} {} {}\n", fieldName(field.info.key), optional ? "?" : "",
                            typeName(field, fmt::format("{}.{}", name, field.info.key)), note(field));
    }
    text += "\n";
}

/// The fields by which objects or the world show properties, under both of their names.
std::string shownFields(Reference const& reference, bool ofObjects) {
    std::string text;
    for (ReferenceProperty const& property : reference.properties) {
        if ((property.home == PropertyHome::objects) != ofObjects) {
            continue;
        }
        PropertyText const& words = property.info->text;
        bool const optional = property.home != PropertyHome::state;
        for (std::string_view const name : {words.name, words.key}) {
            text += fmt::format("---@field [\"{}\"]{} {} {}\n", name, optional ? "?" : "",
                                className(words.key), words.meaning);
        }
    }
    return text;
}

std::string quotedNames(Reference const& reference, bool objectsOnly) {
    std::string all;
    for (ReferenceProperty const& property : reference.properties) {
        if (property.home == PropertyHome::objects || !objectsOnly) {
            for (std::string_view const name : {property.info->text.name, property.info->text.key}) {
                all += fmt::format("---| \"{}\"\n", name);
            }
        }
    }
    return all;
}

void addFunction(std::string& text, ReferenceFunction const& function) {
    std::string const name(function.call->text.name);
    bool const several = function.arguments.size() > 1;
    std::string const arguments = className(fmt::format("{}.{}", function.role->name, name));
    if (several) {
        addClass(text, arguments, fmt::format("The arguments of {} by their names.", name),
                 function.arguments);
    }
    text += fmt::format("--- {}\n", function.call->text.meaning);
    std::string list;
    for (ReferenceField const& argument : function.arguments) {
        text += fmt::format("---@param {}{} {} {}\n", argument.info.key, argument.info.required ? "" : "?",
                            typeName(argument, ""), note(argument));
        list += fmt::format("{}{}", list.empty() ? "" : ", ", argument.info.key);
    }
    text += several ? fmt::format("---@overload fun(arguments: {})\n", arguments) : "";
    text += fmt::format("function {}.{}({}) end\n\n", function.role->name, name, list);
}

void addGlobals(std::string& text) {
    std::set<std::string> libraries;
    for (GlobalNote const& global : globalNotes()) {
        std::string const name(global.name);
        if (name == "interaction" || name == "vec2" || global.inApply) {
            continue; // written by hand below
        }
        std::string use(global.use);
        std::string const result = global.result.empty() ? "" : fmt::format("---@return {}\n", global.result);
        if (auto const method = name.find(':'); method != std::string::npos) {
            text += fmt::format("--- {}\n{}function Vector{} end\n\n", global.meaning, result,
                                use.substr(use.find(':')));
            continue;
        }
        if (auto const dot = name.find('.');
            dot != std::string::npos && libraries.insert(name.substr(0, dot)).second) {
            std::string const library = name.substr(0, dot);
            text += fmt::format("---@class {}\n{} = {{}}\n\n",
                                library == "string" ? "string" : library + "lib", library);
        }
        if (use == name) {
            text += fmt::format("--- {}\n{} = 0\n\n", global.meaning, name);
        } else {
            text += fmt::format("--- {}\n{}function {} end\n\n", global.meaning, result, use);
        }
    }
}

constexpr char const* beginning = R"lua(---@meta trembler
-- What scripts can read and call. Made by `trembler mod annotations`; do not edit.

---@class vec2
---@field x number
---@field y number
---@operator add(vec2): vec2
---@operator sub(vec2): vec2
---@operator unm: vec2
---@operator mul(number): vec2
---@operator div(number): vec2
local Vector = {}

--- A vector.
---@param x number
---@param y number
---@return vec2
function vec2(x, y) end

--- Whether an object is still there.
---@param object trembler.Object?
---@return boolean
function alive(object) end

--- Whether two are one object.
---@param a trembler.Object?
---@param b trembler.Object?
---@return boolean
function same(a, b) end

)lua";

constexpr char const* manifest = R"lua(---@class trembler.Turn
---@field duration number s: since the script's last turn
---@field random fun(): number from 0 to 1, without 1; a replay repeats it

---@class trembler.Store
---@field object table<string, number|boolean|string|vec2> what the script has declared to keep for each object
---@field script table<string, number|boolean|string|vec2> what it has declared to keep for itself

---@class trembler.Parameter
---@field default number|boolean|string|vec2
---@field min? number
---@field max? number
---@field unit? string
---@field text? string
---@field choices? string[]

---@class trembler.Pairs
---@field first trembler.ObjectProperty[] what the one has
---@field second trembler.ObjectProperty[] what the other has
---@field within? number|string m, or the name of a parameter
---@field touching? boolean

---@class trembler.Limits
---@field instructions? integer
---@field instructions_per_object? integer
---@field memory? integer bytes
---@field calls? integer
---@field calls_per_object? integer
---@field log_lines? integer

---@class trembler.Interaction
---@field name string "RESOLVER <- CAUSE"
---@field text? string what it does, for people
---@field calls trembler.Resolver
---@field reads? trembler.Property[]
---@field each? trembler.ObjectProperty[]
---@field pairs? trembler.Pairs
---@field once? boolean
---@field attached? boolean only to objects that name it
---@field restless? boolean in every turn
---@field params? table<string, trembler.Parameter>
---@field store? { object: table?, script: table? }
---@field limits? trembler.Limits
---@field apply fun(object: trembler.Object, params: table, out: trembler.Out, store: trembler.Store, frame: trembler.Turn)|fun(a: trembler.Object, b: trembler.Object, params: table, out: trembler.Out, store: trembler.Store, frame: trembler.Turn)

--- What a script returns: its own description.
---@param description trembler.Interaction
---@return trembler.Interaction
function interaction(description) return description end
)lua";

} // namespace

std::string annotationText(Reference const& reference) {
    std::string text = beginning;
    addGlobals(text);
    for (ReferenceProperty const& property : reference.properties) {
        addClass(text, className(property.info->text.key), property.info->text.meaning, property.fields);
    }
    text += "--- An object. It shows the properties that the script declares.\n---@class trembler.Object\n" +
            shownFields(reference, true) +
            "\n--- The world. It shows the properties that the script declares.\n---@class trembler.World: "
            "trembler.Object\n" +
            shownFields(reference, false) + "\n---@type trembler.World\nworld = {}\n\n";
    RoleInfo const* role = nullptr;
    std::string roles;
    std::string classes;
    for (ReferenceFunction const& function : reference.functions) {
        if (function.role != role) {
            role = function.role;
            text += fmt::format("---@class {}\nlocal {} = {{}}\n\n", className(role->name), role->name);
            roles += fmt::format("---| \"{}\"\n", role->name);
            classes += fmt::format("{}{}", classes.empty() ? "" : ", ", className(role->name));
        }
        addFunction(text, function);
    }
    text += fmt::format(
        "--- The functions of the resolver that the script calls; those of all resolvers are listed.\n"
        "---@class trembler.Out: {}\n\n---@alias trembler.Resolver\n{}\n---@alias "
        "trembler.ObjectProperty\n{}\n---@alias trembler.Property\n{}\n",
        classes, roles, quotedNames(reference, true), quotedNames(reference, false));
    return text + manifest;
}

void writeAnnotations(std::filesystem::path const& folder, Reference const& reference) {
    makeFolder(folder);
    trembler::writeFile(folder / "trembler.lua", annotationText(reference));
}

std::string editorSettings() {
    return R"({
  "runtime.version": "LuaJIT",
  "runtime.builtin": {
    "basic": "disable", "bit": "disable", "bit32": "disable", "coroutine": "disable", "debug": "disable",
    "ffi": "disable", "io": "disable", "jit": "disable", "jit.profile": "disable", "jit.util": "disable",
    "math": "disable", "os": "disable", "package": "disable", "string": "disable", "string.buffer": "disable",
    "table": "disable", "table.clear": "disable", "table.new": "disable", "utf8": "disable"
  }
}
)";
}

} // namespace trembler::lua
