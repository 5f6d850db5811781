// The texts in the program's sources: their literals, and the texts that they look up.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace trembler::ui {

/// Every gap as "{}": "{:.1f} s" becomes "{} s".
inline std::string withBareGaps(std::string const& text) {
    static std::regex const gap(R"(\{[^{}]*\})");
    return std::regex_replace(text, gap, "{}");
}

/// The key of a field as the inspector shows it: "cool_down" as "cool down", "angle_deg" as "angle".
inline std::string spokenKey(std::string key) {
    std::string const degrees = "_deg";
    if (key.size() > degrees.size() && key.ends_with(degrees)) {
        key.resize(key.size() - degrees.size());
    }
    for (char& c : key) {
        c = c == '_' ? ' ' : c;
    }
    return key;
}

template <class Use>
void forEachSource(std::initializer_list<char const*> folders, Use&& use) {
    for (char const* const folder : folders) {
        auto const root = std::filesystem::path(TREMBLER_SOURCE_DIR) / folder;
        for (auto const& entry : std::filesystem::recursive_directory_iterator(root)) {
            if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp") {
                std::ifstream in(entry.path());
                use(std::string(std::istreambuf_iterator<char>(in), {}));
            }
        }
    }
}

/// The literal that begins at `at`, where there is a quotation mark, with the literals that follow it at
/// once; `at` is behind it afterwards.
inline std::string literalAt(std::string const& source, std::size_t& at) {
    std::string text;
    for (;;) {
        for (++at; at < source.size() && source[at] != '"'; ++at) {
            if (source[at] == '\\' && at + 1 < source.size()) {
                ++at;
                text += source[at] == 'n' ? '\n' : source[at];
            } else {
                text += source[at];
            }
        }
        std::size_t const next = source.find_first_not_of(" \n\t", ++at);
        if (next == std::string::npos || source[next] != '"') {
            return text;
        }
        at = next;
    }
}

/// The fault and the expected condition, of a message that states both.
inline std::vector<std::string> halvesOf(std::string const& message) {
    static std::string const expected = "; expected ";
    std::size_t const at = message.find(expected);
    return at == std::string::npos ? std::vector{message}
                                   : std::vector{message.substr(0, at), message.substr(at + expected.size())};
}

/// The place where the bracket at `at` is closed; brackets in literals and characters do not count.
inline std::size_t closingOf(std::string const& source, std::size_t at) {
    int depth = 0;
    for (; at < source.size(); ++at) {
        char const c = source[at];
        if (c == '"') {
            for (++at; at < source.size() && source[at] != '"'; ++at) {
                at += source[at] == '\\' ? 1 : 0;
            }
        } else if (c == '\'' && at + 2 < source.size() && source[at + 2] == '\'') {
            at += 2;
        } else if (c == '(' || c == '{' || c == '[') {
            ++depth;
        } else if ((c == ')' || c == '}' || c == ']') && --depth == 0) {
            return at;
        }
    }
    return source.size();
}

/// Whether a text has words, so that it needs a translation.
inline bool hasWords(std::string const& text) {
    static std::regex const word("[A-Za-z]{2,}");
    return text.find(' ') != std::string::npos && std::regex_search(text, word);
}

/// Adds the literals that a source passes to functions that report faults, or returns as a fault. `onlyBoth`:
/// only of messages that also state the expected condition.
inline void addMessages(std::string const& source, bool onlyBoth, std::set<std::string>& all) {
    if (onlyBoth && source.find("; expected ") == std::string::npos) {
        return;
    }
    static std::regex const head(
        R"re(\b(?:complain(?:At|OfType|AboutKey)?|diagnostic|CommandError|refuse(?:Type|Scale|Size)?|problem|)re"
        R"re(raise|isObject|isList|required|mustHave|mustBeName|stop|name|text|reader|fail|Fault)\(|)re"
        R"re(\b(?:Impossibility|ChangeFault|SourceFault|return)\s*\{|\.(?:message|expected) = |)re"
        R"re(return fmt::format\()re");
    for (std::sregex_iterator found(source.begin(), source.end(), head), end; found != end; ++found) {
        std::size_t const open = static_cast<std::size_t>(found->position() + found->length()) - 1;
        bool const bracket = source[open] == '(' || source[open] == '{';
        std::size_t const close = bracket ? closingOf(source, open) : source.find(';', open);
        for (std::size_t at = open; (at = source.find('"', at)) < close;) {
            if (source[at - 1] == '\'') { // a character
                ++at;
                continue;
            }
            if (source[at - 1] == 'R') { // a file's content, not a message
                at = std::min(source.find(")\"", at), source.size() - 2) + 2;
                continue;
            }
            std::string const message = literalAt(source, at);
            std::vector<std::string> const halves = halvesOf(message);
            if (onlyBoth && halves.size() < 2) {
                continue;
            }
            for (std::string const& half : halves) {
                if (hasWords(half)) {
                    all.insert(half);
                }
            }
        }
    }
}

/// The refusals of classes without a window, and their messages about files.
inline std::set<std::string> messagesOfTheProgram() {
    std::set<std::string> all;
    forEachSource({"runtime/level/build", "runtime/level/json", "runtime/level/model",
                   "runtime/level/property", "runtime/level/read", "puzzle/edit", "puzzle/goals",
                   "puzzle/checks", "puzzle/session", "puzzle/data", "lua/sandbox", "lua/binding",
                   "lua/interaction", "lua/component", "lua/attach"},
                  [&](std::string const& source) { addMessages(source, false, all); });
    forEachSource({"physics", "audio/effect"},
                  [&](std::string const& source) { addMessages(source, true, all); });
    return all;
}

/// All literals, with bare gaps, and as keys of fields are shown.
inline std::set<std::string> literalsOfTheProgram() {
    std::set<std::string> all;
    forEachSource({"game", "insight", "puzzle", "physics", "audio", "runtime", "lua", "render"},
                  [&](std::string const& source) {
                      for (std::size_t at = 0; (at = source.find('"', at)) != std::string::npos;) {
                          if (at > 0 && source[at - 1] == '\'') { // a character
                              ++at;
                              continue;
                          }
                          std::string const text = literalAt(source, at);
                          all.insert(withBareGaps(text));
                          all.insert(spokenKey(text));
                          for (std::string const& half : halvesOf(text)) {
                              all.insert(withBareGaps(half));
                          }
                          if (std::size_t const arrow = text.find(" <- "); arrow != std::string::npos) {
                              all.insert(text.substr(arrow + 4)); // the causes of an interaction
                          }
                      }
                  });
    return all;
}

/// The texts of all calls of text(), textWith(), said() and phrase() in the game; the editor has its own
/// test.
inline std::set<std::string> textsAskedFor() {
    std::set<std::string> all;
    static std::regex const call(R"((?:^|[^.\w])(?:text|textWith|said|phrase)\(\s*")");
    auto const gather = [&](std::string const& source) {
        for (std::sregex_iterator at(source.begin(), source.end(), call), end; at != end; ++at) {
            auto begin = static_cast<std::size_t>(at->position() + at->length() - 1);
            all.insert(literalAt(source, begin));
        }
    };
    forEachSource({"game/ui/app", "game/ui/cards", "game/ui/panels", "game/ui/play", "game/ui/shared",
                   "game/ui/tools", "puzzle/goals/conditions", "puzzle/goals/words"},
                  gather);
    return all;
}

/// The known ids that a source of the window mentions, and the ids that it asks for.
inline std::set<std::string> idsMentioned(std::set<std::string> const& known) {
    std::set<std::string> ids;
    static std::regex const call(R"re(\btext(?:With)?\("([a-z_]+\.[a-z_.]+)")re");
    forEachSource({"game/ui"}, [&](std::string const& source) {
        for (std::sregex_iterator at(source.begin(), source.end(), call), end; at != end; ++at) {
            ids.insert((*at)[1]);
        }
        for (std::string const& id : known) { // also where a function passes it on
            if (source.find("\"" + id + "\"") != std::string::npos) {
                ids.insert(id);
            }
        }
    });
    return ids;
}

} // namespace trembler::ui
