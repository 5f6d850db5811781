#include "puzzle/edit/text/lay_out.hpp"

#include "runtime/file/visible_text.hpp"

#include <algorithm>

namespace trembler::edit {
namespace {

using Tree = nlohmann::ordered_json;

std::string scalarText(Tree const& value) {
    return escapedJson(value.dump(-1, ' ', false, Tree::error_handler_t::replace));
}

std::string keyText(std::string const& key) {
    return scalarText(Tree(key)) + ": ";
}

/// Whether the entries are numbers, or lists of numbers: they follow each other in lines.
bool isNumbers(Tree const& list) {
    return std::all_of(list.begin(), list.end(), [](Tree const& entry) {
        return entry.is_number() ||
               (entry.is_array() &&
                std::all_of(entry.begin(), entry.end(), [](Tree const& inner) { return inner.is_number(); }));
    });
}

std::string listText(Tree const& list, std::size_t indent) {
    std::string const inside = "\n" + std::string(indent + 2, ' ');
    bool const fills = isNumbers(list);
    std::string out = "[";
    std::size_t width = widestLine; // of the present line: the first entry begins a line
    for (std::size_t i = 0; i < list.size(); ++i) {
        std::string const text = layOut(list[i], indent + 2, indent + 2);
        out += i == 0 ? "" : ",";
        if (fills && width + text.size() + 3 <= widestLine) {
            out += " " + text;
            width += text.size() + 2;
        } else {
            out += inside + text;
            width = indent + 2 + text.size();
        }
    }
    return out + "\n" + std::string(indent, ' ') + "]";
}

std::string objectText(Tree const& object, std::size_t indent, std::size_t column) {
    std::string out = "{";
    std::size_t width = column + 1;
    bool first = true;
    for (auto const& [key, value] : object.items()) {
        std::string const begin = keyText(key);
        std::string const whole = begin + inOneLine(value);
        if (first || width + whole.size() + 3 <= widestLine) {
            out += first ? "" : ", ";
            width += first ? 0 : 2;
            std::string const text = layOut(value, indent, width + begin.size());
            out += begin + text;
        } else {
            out += ",\n" + std::string(indent + 1, ' ');
            out += begin + layOut(value, indent + 1, indent + 1 + begin.size());
        }
        std::size_t const line = out.rfind('\n');
        width = line == std::string::npos ? column + out.size() : out.size() - line - 1;
        first = false;
    }
    return out + "}";
}

} // namespace

std::string inOneLine(Tree const& value) {
    if (!value.is_structured()) {
        return scalarText(value);
    }
    std::string out = value.is_array() ? "[" : "{";
    bool first = true;
    for (auto const& item : value.items()) {
        out += first ? "" : ", ";
        out += value.is_array() ? "" : keyText(item.key());
        out += inOneLine(item.value());
        first = false;
    }
    return out + (value.is_array() ? "]" : "}");
}

std::string layOut(Tree const& value, std::size_t indent, std::size_t column) {
    std::string line = inOneLine(value);
    if (column + line.size() + 1 <= widestLine || !value.is_structured() || value.empty()) {
        return line;
    }
    return value.is_array() ? listText(value, indent) : objectText(value, indent, column);
}

std::string layOutFile(Tree const& value) {
    if (!value.is_object() || value.empty()) {
        return layOut(value) + "\n";
    }
    std::string out = "{";
    for (auto const& [key, member] : value.items()) {
        std::string const begin = keyText(key);
        out += out.size() == 1 ? "\n  " : ",\n  ";
        bool const alwaysBroken = member.is_array() && !member.empty() && member.front().is_object();
        out += begin + (alwaysBroken ? listText(member, 2) : layOut(member, 2, 2 + begin.size()));
    }
    return out + "\n}\n";
}

} // namespace trembler::edit
