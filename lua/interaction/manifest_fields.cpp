// The fields of a table in a manifest: names, texts and flags, and their errors.
#include "lua/interaction/manifest_fields.hpp"

#include "runtime/file/visible_text.hpp"
#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace trembler::lua {

using nlohmann::json;

void ManifestFields::complain(std::string_view word, std::string message, std::string expected) const {
    problems_.add(place_.problem(word, std::move(message), std::move(expected)));
}

void ManifestFields::complainIn(std::string_view table, std::string_view word, std::string message,
                                std::string expected) const {
    problems_.add(place_.problem(word, std::move(message), std::move(expected), table));
}

void ManifestFields::onlyKeys(json const& table, std::string const& where,
                              std::vector<std::string> const& known) const {
    if (!table.is_object()) {
        return;
    }
    for (auto const& [key, value] : table.items()) {
        if (std::find(known.begin(), known.end(), key) == known.end()) {
            complain(key, fmt::format("unknown key '{}'{}{}", key, where, didYouMean(key, known)),
                     listed(known));
        }
    }
}

std::string ManifestFields::text(json const& table, char const* key, bool required,
                                 std::size_t longest) const {
    if (!table.contains(key)) {
        if (required) {
            complain("", fmt::format("'{}' is missing", key), fmt::format("{} = \"...\"", key));
        }
        return {};
    }
    if (!table[key].is_string() || table[key].get<std::string>().size() > longest ||
        table[key].get<std::string>().empty()) {
        complain(key, fmt::format("'{}' is no text of 1 to {} bytes", key, longest), "a text");
        return {};
    }
    auto stated = table[key].get<std::string>();
    // Lists, logs and messages show it in a line; what is behind a line end could pass for their own words.
    if (hasControlCharacter(stated)) {
        complain(key, fmt::format("'{}' has a line end or another control character", key), "one line");
        return {};
    }
    return stated;
}

bool ManifestFields::flag(json const& table, char const* key) const {
    if (!table.contains(key)) {
        return false;
    }
    if (!table[key].is_boolean()) {
        complain(key, fmt::format("'{}' is not true or false", key), "true or false");
        return false;
    }
    return table[key].get<bool>();
}

std::vector<std::string> ManifestFields::namesIn(json const& list, std::string_view key,
                                                 NamesWords const& words) const {
    std::vector<std::string> all;
    bool good = list.is_array() && list.size() <= 50;
    for (json const& name : good ? list : json::array()) {
        if (!name.is_string()) {
            good = false;
        } else if (std::find(all.begin(), all.end(), name.get<std::string>()) != all.end()) {
            complain(name.get<std::string>(), fmt::format("'{}' is repeated", name.get<std::string>()),
                     std::string(words.once));
        } else {
            all.push_back(name.get<std::string>());
        }
    }
    if (!good) {
        complain(key, fmt::format(fmt::runtime(words.wrong), key),
                 fmt::format(fmt::runtime(words.example), key));
    }
    return all;
}

std::vector<std::string> ManifestFields::names(json const& table, char const* key) const {
    return table.contains(key) ? namesIn(table[key], key) : std::vector<std::string>();
}

} // namespace trembler::lua
