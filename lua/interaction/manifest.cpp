// Manifests: running a script once to get its statements about itself, and finding the line of a word in it.
#include "lua/interaction/manifest.hpp"

#include "lua/interaction/lua_tree.hpp"
#include "lua/interaction/manifest_reader.hpp"
#include "lua/sandbox/limits.hpp"
#include "lua/sandbox/source/scanner.hpp"
#include "runtime/level/json/read_text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <lua.hpp>

namespace trembler::lua {
namespace {

bool isWordCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Where a word first stands in a text by itself; npos: nowhere.
std::size_t placeOf(std::string_view source, std::string_view word, std::size_t from = 0) {
    for (std::size_t at = word.empty() ? std::string_view::npos : source.find(word, from);
         at != std::string_view::npos; at = source.find(word, at + 1)) {
        bool const begins = at == 0 || !isWordCharacter(source[at - 1]) || !isWordCharacter(word.front());
        bool const ends = at + word.size() == source.size() || !isWordCharacter(source[at + word.size()]) ||
                          !isWordCharacter(word.back());
        if (begins && ends) {
            return at;
        }
    }
    return std::string_view::npos;
}

/// The line of a place in a text, from 1.
std::size_t lineAt(std::string_view source, std::size_t at) {
    return 1 + static_cast<std::size_t>(
                   std::count(source.begin(), source.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

/// The column of a place in a text, from 1, in bytes.
std::size_t columnOf(std::string_view source, std::size_t at) {
    std::size_t const end = at == 0 ? std::string_view::npos : source.rfind('\n', at - 1);
    return end == std::string_view::npos ? at + 1 : at - end;
}

/// The column of an error in a line: that of the token that LuaJIT's message names, "... near 'x'", if it
/// stands there, else that of the line's first token. 1 if there is none.
std::size_t columnOfError(std::string_view source, std::size_t line, std::string_view message) {
    std::size_t const near = message.rfind(" near '");
    std::string_view named = near == std::string_view::npos ? std::string_view() : message.substr(near + 7);
    named.remove_suffix(named.empty() ? 0 : 1);
    std::size_t first = 0;
    SourceScanner scanner(source);
    while (scanner.next() != SourceScanner::Kind::end && scanner.line() <= line) {
        if (scanner.line() < line) {
            continue;
        }
        first = first == 0 ? columnOf(source, scanner.begin()) : first;
        if (!named.empty() && source.substr(scanner.begin(), scanner.end() - scanner.begin()) == named) {
            return columnOf(source, scanner.begin());
        }
    }
    return first == 0 ? 1 : first;
}

} // namespace

Parameter const* Manifest::parameter(std::string_view name_) const {
    auto const at = std::find_if(parameters.begin(), parameters.end(),
                                 [&](Parameter const& parameter) { return parameter.name == name_; });
    return at == parameters.end() ? nullptr : &*at;
}

std::size_t Manifest::lineOf(std::string_view word) const {
    std::size_t const at = placeOf(source, word);
    return at == std::string::npos ? 0 : lineAt(source, at);
}

Diagnostic Manifest::problem(std::string_view word, std::string message, std::string expected,
                             std::string_view table) const {
    std::size_t const begin = placeOf(source, table);
    std::size_t const at = placeOf(source, word, begin == std::string::npos ? 0 : begin);
    return {.file = file,
            .line = at == std::string::npos ? std::size_t{0} : lineAt(source, at),
            .column = at == std::string::npos ? std::size_t{0} : columnOf(source, at),
            .path = "",
            .message = std::move(message),
            .expected = std::move(expected)};
}

Manifest readManifest(std::string source, std::string file, Problems& problems) {
    Manifest manifest;
    manifest.source = std::move(source);
    manifest.file = std::move(file);
    std::string const name = std::filesystem::path(manifest.file).filename().string();
    Sandbox sandbox(ScriptLimits{});
    nlohmann::json tree;
    auto failed = sandbox.load(manifest.source, name);
    if (!failed) {
        failed = sandbox.turn(100, [&](lua_State* L) {
            sandbox.pushChunk(L);
            sandbox.callScript(L, 0, 1);
            tree = treeOf(L, lua_gettop(L), 0);
        });
    }
    if (failed) { // its message begins with NAME:LINE:
        Diagnostic problem{.file = manifest.file, .path = "", .message = failed->message, .expected = ""};
        if (failed->message.starts_with(name + ":")) {
            char* end = nullptr;
            char const* const number = failed->message.c_str() + name.size() + 1;
            problem.line = std::strtoul(number, &end, 10);
            problem.column =
                problem.line == 0 ? 0 : columnOfError(manifest.source, problem.line, failed->message);
            if (end != number) {
                problem.message = failed->message.substr(std::min(
                    failed->message.size(), static_cast<std::size_t>(end - failed->message.c_str()) + 2));
            }
        }
        problems.add(std::move(problem));
        return manifest;
    }
    readInto(manifest, tree, problems);
    return manifest;
}

Manifest loadManifest(std::filesystem::path const& path, Problems& problems) {
    try {
        return readManifest(readText(path, longestSource), path.string(), problems);
    } catch (InputError const& error) {
        for (Diagnostic const& problem : error.diagnostics()) {
            problems.add(problem);
        }
        return {};
    }
}

} // namespace trembler::lua
