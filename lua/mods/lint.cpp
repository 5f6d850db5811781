#include "lua/mods/lint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <utility>

namespace trembler::lua {
namespace {

bool isPartOfAName(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// The text without comments, so that a name that only comments mention does not count as used. Strings stay.
std::string withoutComments(std::string_view text) {
    std::string kept;
    for (std::size_t i = 0; i < text.size(); ++i) {
        char const c = text[i];
        if (c == '"' || c == '\'') {
            std::size_t end = i + 1;
            while (end < text.size() && text[end] != c && text[end] != '\n') {
                end += text[end] == '\\' ? 2 : 1;
            }
            end = std::min(end, text.size() - 1);
            kept += text.substr(i, end - i + 1);
            i = end;
        } else if (text.substr(i, 4) == "--[[") {
            std::size_t const end = text.find("]]", i);
            i = end == std::string_view::npos ? text.size() : end + 1;
        } else if (text.substr(i, 2) == "--") {
            std::size_t const end = text.find('\n', i);
            i = end == std::string_view::npos ? text.size() : end - 1;
        } else {
            kept += c;
        }
    }
    return kept;
}

/// How often a name stands in the text by itself.
std::size_t mentions(std::string_view text, std::string_view name) {
    std::size_t count = 0;
    for (std::size_t at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1)) {
        std::size_t const end = at + name.size();
        bool const begins = at == 0 || !isPartOfAName(text[at - 1]);
        bool const ends = end == text.size() || !isPartOfAName(text[end]);
        count += begins && ends ? 1 : 0;
    }
    return count;
}

bool contains(std::vector<std::string> const& names, std::string const& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

} // namespace

std::vector<Diagnostic> lint(Manifest const& manifest) {
    std::vector<Diagnostic> found;
    std::string const text = withoutComments(manifest.source);
    for (std::string const& read : manifest.reads) {
        // A property that selects objects is read in any case, whether 'reads' repeats it or not.
        bool const selects = contains(manifest.first, read) || contains(manifest.second, read);
        if (!selects && mentions(text, read) < 2) {
            found.push_back(
                manifest.problem(read, fmt::format("'{}' in 'reads' is never read", read),
                                 "only properties that apply reads: each change of one wakes the script"));
        }
    }
    for (Parameter const& parameter : manifest.parameters) {
        if (mentions(text, parameter.name) < 2 && manifest.withinParameter != parameter.name) {
            found.push_back(manifest.problem(parameter.name,
                                             fmt::format("the parameter '{}' has no effect", parameter.name),
                                             fmt::format("params.{} somewhere in apply", parameter.name)));
        }
        if (parameter.text.empty()) {
            found.push_back(manifest.problem(
                parameter.name,
                fmt::format("the parameter '{}' has no description for players", parameter.name),
                "text = \"...\""));
        }
        if (std::holds_alternative<double>(parameter.initial) &&
            (parameter.minimum <= -1e300 || parameter.maximum >= 1e300)) {
            found.push_back(manifest.problem(
                parameter.name,
                fmt::format("the parameter '{}' has no range, so players get no slider", parameter.name),
                "min = ..., max = ..."));
        }
    }
    for (auto const& [fields, where] :
         {std::pair{&manifest.objectStore, "object"}, std::pair{&manifest.scriptStore, "script"}}) {
        for (StoreField const& field : *fields) {
            if (mentions(text, field.name) < 2) {
                found.push_back(
                    manifest.problem(field.name, fmt::format("'{}' in 'store' is never used", field.name),
                                     fmt::format("store.{}.{} somewhere in apply", where, field.name)));
            }
        }
    }
    if (manifest.text.empty()) {
        found.push_back(
            manifest.problem("name", "the interaction has no description", "text = \"...\", for players"));
    }
    std::stable_sort(found.begin(), found.end(),
                     [](Diagnostic const& a, Diagnostic const& b) { return a.line < b.line; });
    return found;
}

} // namespace trembler::lua
