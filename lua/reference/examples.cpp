#include "lua/reference/examples.hpp"

#include "lua/reference/function_examples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace trembler::lua {
namespace {

std::string indented(std::string_view text, std::size_t depth) {
    std::string all;
    while (!text.empty()) {
        std::size_t const end = text.find('\n');
        std::string_view const line = text.substr(0, end);
        all += line.empty() ? "\n" : fmt::format("{}{}\n", std::string(depth, ' '), line);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return all;
}

std::string unitNote(ReferenceField const& field) {
    return field.info.unit.empty() ? std::string() : fmt::format(" -- {}", field.info.unit);
}

// Statements that read a field, which the expression stands for. An entry of a list has only the fields that
// its form has, for example no corners if it is a circle.
std::string reading(ReferenceField const& field, std::string const& expression, std::size_t depth) {
    switch (field.kind) {
    case FieldKind::vector:
        return depth == 0 ? fmt::format("log({0}.x, {0}.y){1}\n", expression, unitNote(field))
                          : fmt::format("log({}){}\n", expression, unitNote(field));
    case FieldKind::object:
        return fmt::format("log(alive({}))\n", expression);
    case FieldKind::list: {
        constexpr std::array<std::string_view, 3> names{"entry", "part", "piece"};
        std::string const name(names[std::min(depth, names.size() - 1)]);
        std::string inner;
        for (ReferenceField const& part : field.entry) {
            bool const value = !field.entriesHaveFields;
            inner += reading(part, value ? name : memberOf(name, part.info.key), depth + 1);
        }
        return fmt::format("for _, {} in ipairs({} or {{}}) do\n{}end\n", name, expression,
                           indented(inner, 2));
    }
    default:
        return fmt::format("log({}){}\n", expression, unitNote(field));
    }
}

/// A value that an argument can have, as Lua.
std::string anyValue(ReferenceField const& argument) {
    FieldInfo const& info = argument.info;
    double const number = std::clamp(1.0, info.minimum, std::max(info.minimum, info.maximum));
    switch (argument.kind) {
    case FieldKind::boolean:
        return "true";
    case FieldKind::integer:
    case FieldKind::whole:
        return fmt::format("{:g}", std::ceil(number));
    case FieldKind::number:
        return fmt::format("{:g}", number);
    case FieldKind::vector:
        return fmt::format("vec2({0:g}, {0:g})", number);
    case FieldKind::object:
        return "object";
    case FieldKind::choice:
        return fmt::format("\"{}\"", argument.choices.front());
    case FieldKind::part:
        return "\"rubber ball\"";
    default:
        return "\"\"";
    }
}

std::string madeExample(ReferenceFunction const& function) {
    std::string arguments;
    for (ReferenceField const& argument : function.arguments) {
        arguments +=
            fmt::format("{}{} = {}", arguments.empty() ? " " : ", ", argument.info.key, anyValue(argument));
    }
    return fmt::format(R"(return interaction {{
  name = "{0} <- Example",
  calls = "{0}",
  reads = {{ "Position" }},
  each = {{ "Position" }},
  apply = function(object, params, out)
    out.{1}{2}
  end,
}}
)",
                       function.role->name, function.call->text.name,
                       function.arguments.size() == 1
                           ? fmt::format("({})", anyValue(function.arguments.front()))
                           : fmt::format("{{{} }}", arguments));
}

std::string_view writtenExample(ReferenceFunction const& function) {
    auto const examples = functionExamples();
    auto const at = std::find_if(examples.begin(), examples.end(), [&](FunctionExample const& one) {
        return one.role == function.role->name && one.function == function.call->text.name;
    });
    return at == examples.end() ? std::string_view() : at->script;
}

} // namespace

std::string functionExample(ReferenceFunction const& function) {
    std::string_view const written = writtenExample(function);
    return written.empty() ? madeExample(function) : std::string(written);
}

std::string propertyExampleBody(ReferenceProperty const& property) {
    std::string const expression = expressionOf(property);
    std::string body;
    for (ReferenceField const& field : property.fields) {
        body += reading(field, memberOf(expression, field.info.key), 0);
    }
    if (body.empty()) {
        body = fmt::format("log({} ~= nil)\n", expression);
    }
    if (property.home == PropertyHome::world) {
        body = fmt::format("if {} then\n{}end\n", expression, indented(body, 2));
    }
    return body;
}

std::string propertyExample(ReferenceProperty const& property) {
    bool const ofObjects = property.home == PropertyHome::objects;
    std::string_view const name = scriptName(*property.info);
    return fmt::format(R"(return interaction {{
  name = "Frame <- {0}",
  calls = "Frame",
  reads = {{ "{0}" }},
  {1},
  apply = function({2}, params, out)
{3}  end,
}}
)",
                       name,
                       ofObjects ? fmt::format("each = {{ \"{}\" }}", name) : std::string("once = true"),
                       ofObjects ? "object" : "world", indented(property.body, 4));
}

} // namespace trembler::lua
