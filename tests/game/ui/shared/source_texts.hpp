// What the program's sources say: their literals, and the texts that they ask for.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

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

/// The literal that begins at `at`, where there is a quotation mark, with those that follow it at once; `at`
/// is behind it afterwards.
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
    static std::regex const call(R"(\b(?:text|textWith|said|phrase)\(\s*")");
    auto const gather = [&](std::string const& source) {
        for (std::sregex_iterator at(source.begin(), source.end(), call), end; at != end; ++at) {
            auto begin = static_cast<std::size_t>(at->position() + at->length() - 1);
            all.insert(literalAt(source, begin));
        }
    };
    forEachSource({"game/ui/app", "game/ui/cards", "game/ui/commands", "game/ui/panels", "game/ui/play",
                   "game/ui/shared", "game/ui/tools", "puzzle/goals/conditions", "puzzle/goals/words"},
                  gather);
    return all;
}

/// The ids among the known ones that a source of the window's mentions, and those that it asks for.
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
