#include "insight/probe/named_numbers.hpp"

#include "runtime/file/lower_case.hpp"
#include "runtime/level/json/suggestion.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace trembler::watch {
namespace {

bool canBePlotted(WatchedField const& field) {
    return field.type != FieldType::text && field.type != FieldType::object &&
           field.type != FieldType::choice;
}

/// The longest name of an object that begins the word and is followed by a dot.
std::string objectAtBeginning(World const& world, std::string_view word) {
    for (std::size_t at = word.rfind('.'); at != std::string_view::npos && at > 0;
         at = word.rfind('.', at - 1)) {
        std::string name(word.substr(0, at));
        if (world.store().find(name).valid()) {
            return name;
        }
    }
    return "";
}

/// The name as people say it; the name in files where that is made of several symbols: "c_c,_c_n,_c_p".
std::string const& shownOf(std::string const& name, std::string const& spoken) {
    return spoken.find(',') == std::string::npos ? spoken : name;
}

/// A name, and the words that a player may have meant to type for it.
struct Candidate {
    std::string what;
    std::vector<std::string> words;
    bool numbered = false;
};

std::vector<Candidate> candidatesOf(World const& world, std::vector<WatchedField> const& fields,
                                    std::string const& object) {
    std::vector<Candidate> all;
    for (WatchedField const& field : fields) {
        if (canBePlotted(field) && concerns(world, field, object)) {
            std::string const name = field.name();
            std::string const spoken = field.spokenName();
            Candidate& made =
                all.emplace_back(Candidate{object + "." + shownOf(name, spoken),
                                           {object + "." + name, object + "." + spoken, name, spoken}});
            made.numbered = field.numbered();
            if (!made.numbered && field.key != "value") {
                made.words.push_back(field.key);
            }
        }
    }
    std::stable_sort(all.begin(), all.end(),
                     [](Candidate const& a, Candidate const& b) { return !a.numbered && b.numbered; });
    return all;
}

/// The name as it was typed, if it is the exact name of a number.
std::optional<std::string> exactName(World const& world, std::vector<WatchedField> const& fields,
                                     std::string const& name) {
    try {
        return canBePlotted(find(world, fields, name).field()) ? std::optional(name) : std::nullopt;
    } catch (std::invalid_argument const&) { // no such name
        return std::nullopt;
    }
}

std::vector<std::string> similarNames(World const& world, std::vector<Candidate> const& candidates,
                                      std::string const& word) {
    std::vector<std::string> words;
    std::vector<std::string const*> meant; // for each of the words
    for (Candidate const& candidate : candidates) {
        for (std::string const& each : candidate.words) {
            words.push_back(inLowerCase(each));
            meant.push_back(&candidate.what);
        }
    }
    if (auto const nearest = suggestion(word, words)) {
        std::vector<std::string> similar;
        for (std::size_t i = 0; i < words.size(); ++i) {
            if (words[i] == *nearest &&
                std::find(similar.begin(), similar.end(), *meant[i]) == similar.end()) {
                similar.push_back(*meant[i]);
            }
        }
        return similar;
    }
    std::size_t const dot = word.find('.');
    if (dot == std::string::npos) {
        return {};
    }
    auto const object = suggestion(word.substr(0, dot), objectNames(world));
    return object ? std::vector{*object + word.substr(dot)} : std::vector<std::string>{};
}

} // namespace

NamedNumbers namedNumbers(World const& world, std::vector<WatchedField> const& fields,
                          std::string const& object, std::string_view word, std::size_t most) {
    NamedNumbers result;
    std::vector<std::string> objects;
    for (std::string const& one : {objectAtBeginning(world, word), object, std::string("world")}) {
        if (!one.empty() && std::find(objects.begin(), objects.end(), one) == objects.end()) {
            objects.push_back(one);
        }
    }
    auto exact = exactName(world, fields, std::string(word));
    for (auto one = objects.begin(); !exact && one != objects.end(); ++one) {
        exact = exactName(world, fields, *one + "." + std::string(word));
    }
    if (exact) {
        result.found.push_back(*exact);
    }
    std::string const lower = inLowerCase(word);
    std::vector<Candidate> all;
    for (std::string const& one : objects) {
        std::vector<Candidate> const candidates = candidatesOf(world, fields, one);
        all.insert(all.end(), candidates.begin(), candidates.end());
    }
    for (Candidate const& candidate : all) {
        bool const contains =
            std::any_of(candidate.words.begin(), candidate.words.end(), [&](std::string const& each) {
                return inLowerCase(each).find(lower) != std::string::npos;
            });
        if (contains && (!exact || candidate.what != *exact)) {
            if (result.found.size() < most) {
                result.found.push_back(candidate.what);
            } else {
                ++result.more;
            }
        }
    }
    if (result.found.empty()) {
        result.similar = similarNames(world, all, lower);
    }
    return result;
}

} // namespace trembler::watch
