// Reads a manifest out of the table that a script returns.
#include "lua/interaction/manifest_reader.hpp"

#include "lua/interaction/allowed_limits.hpp"
#include "lua/interaction/lua_tree.hpp"
#include "lua/interaction/manifest_fields.hpp"
#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

namespace trembler::lua {

using nlohmann::json;

namespace {

/// Of a store, for objects or for the script.
constexpr std::size_t mostStoreFields = 32;
/// Bytes that a state needs before any script runs in it.
constexpr std::size_t leastMemory = std::size_t{1} << 19U;

bool isIdentifier(std::string_view name) {
    auto const good = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    return !name.empty() && name.size() <= 40 && std::all_of(name.begin(), name.end(), good) &&
           std::isdigit(static_cast<unsigned char>(name.front())) == 0;
}

class ManifestReader : ManifestFields {
public:
    ManifestReader(Manifest& manifest, Problems& problems)
        : ManifestFields(manifest, problems), manifest_(manifest) {}

    void read(json const& all) {
        if (!all.is_object()) {
            complain("", "the script returns no interaction",
                     "return interaction { name = ..., apply = function ... }");
            return;
        }
        onlyKeys(all, "",
                 {"name", "text", "reads", "calls", "each", "pairs", "once", "attached", "restless", "params",
                  "store", "limits", "apply"});
        manifest_.name = text(all, "name", true, 80);
        if (!manifest_.name.empty() && manifest_.name.find(" <- ") == std::string::npos) {
            complain("name", fmt::format("the name '{}' does not state what is connected", manifest_.name),
                     "\"RESOLVER <- CAUSE\", for example \"Dynamics <- Wind\"");
        }
        manifest_.text = text(all, "text", false, 500);
        manifest_.calls = text(all, "calls", true, 80);
        std::size_t const arrow = manifest_.name.find(" <- ");
        if (arrow != std::string::npos && !manifest_.calls.empty() &&
            manifest_.name.substr(0, arrow) != manifest_.calls) {
            complain("name",
                     fmt::format("the name '{}' and calls = \"{}\" differ in the resolver", manifest_.name,
                                 manifest_.calls),
                     fmt::format("a name that begins with \"{} <- \", or calls = \"{}\"", manifest_.calls,
                                 manifest_.name.substr(0, arrow)));
        }
        manifest_.reads = names(all, "reads");
        manifest_.attached = flag(all, "attached");
        manifest_.restless = flag(all, "restless");
        readApplication(all);
        readParameters(all);
        readStore(all);
        readLimits(all);
        if (!all.contains("apply") || !isFunction(all["apply"])) {
            complain("apply", "'apply' is missing", "apply = function(object, params, out) ... end");
        }
    }

private:
    void readApplication(json const& all) {
        int const stated = static_cast<int>(all.contains("each")) + static_cast<int>(all.contains("pairs")) +
                           static_cast<int>(all.contains("once"));
        if (stated != 1) {
            complain(
                "apply", "the objects to which the script is applied are not stated",
                "one of each = { properties }, pairs = { { properties }, { properties }, within = metres or "
                "touching = true }, once = true");
            return;
        }
        if (all.contains("once")) {
            manifest_.application = Application::once;
            if (!flag(all, "once") || manifest_.attached) {
                complain("once", "'once' is neither true nor for objects that name the script",
                         "once = true, and no 'attached'");
            }
            return;
        }
        if (all.contains("each")) {
            manifest_.first = names(all, "each");
            if (manifest_.first.empty() && !manifest_.attached) {
                complain("each", "'each' selects every object", "at least one property, or attached = true");
            }
            return;
        }
        manifest_.application = Application::pairs;
        // A table with a list and keys comes out as its keys only, so the lists are named.
        json const& pairs = all["pairs"];
        onlyKeys(pairs, " in 'pairs'", {"first", "second", "within", "touching"});
        if (!pairs.is_object() || !pairs.contains("first") || !pairs.contains("second")) {
            complain("pairs", "'pairs' does not state both kinds of objects",
                     "pairs = { first = { properties }, second = { properties }, within = 3 }");
            return;
        }
        manifest_.first = namesIn(pairs["first"], "first");
        manifest_.second = namesIn(pairs["second"], "second");
        manifest_.touching = flag(pairs, "touching");
        if (pairs.contains("within") && pairs["within"].is_string()) {
            manifest_.withinParameter = pairs["within"].get<std::string>();
        } else if (pairs.contains("within") && pairs["within"].is_number()) {
            manifest_.within = pairs["within"].get<double>();
        }
        if (manifest_.touching == (manifest_.within > 0 || !manifest_.withinParameter.empty()) ||
            manifest_.within < 0 || !(manifest_.within <= 1e6)) {
            complain("pairs", "'pairs' does not state one condition of distance",
                     "either within = metres above 0, or the name of a parameter, or touching = true");
        }
        if (manifest_.second.empty()) {
            complain("second", "'second' selects every object", "at least one property");
        }
    }

    void readParameters(json const& all) {
        if (!all.contains("params")) {
            checkWithin();
            return;
        }
        json const& table = all["params"];
        if (!table.is_object() && !(table.is_array() && table.empty())) {
            complain(
                "params", "'params' is no table of parameters",
                "params = { speed = { default = 8, min = 0, max = 60, unit = \"m/s\", text = \"...\" } }");
            return;
        }
        for (auto const& [name, stated] : table.items()) {
            readParameter(name, stated);
        }
        checkWithin();
    }
    void readParameter(std::string const& name, json const& stated) {
        Parameter made;
        made.name = name;
        if (!isIdentifier(name)) {
            complain(name, fmt::format("'{}' is no name of a parameter", name), "letters, digits and _");
            return;
        }
        onlyKeys(stated, fmt::format(" of parameter '{}'", name),
                 {"default", "min", "max", "unit", "text", "choices"});
        auto const initial =
            stated.is_object() && stated.contains("default") ? valueOf(stated["default"]) : std::nullopt;
        if (!initial || !isFinite(*initial)) {
            complain(name, fmt::format("parameter '{}' has no default", name),
                     "default = a number, true or false, vec2(x, y) or a text");
            return;
        }
        made.initial = *initial;
        made.unit = text(stated, "unit", false, 20);
        made.text = text(stated, "text", false, 300);
        made.choices = stated.contains("choices") ? namesIn(stated["choices"], "choices", choiceWords)
                                                  : std::vector<std::string>();
        if (double const* const number = std::get_if<double>(&made.initial)) {
            bool good = true;
            for (auto const& [key, limit] : {std::pair{"min", &made.minimum}, {"max", &made.maximum}}) {
                if (stated.contains(key)) {
                    good = good && stated[key].is_number() && std::isfinite(stated[key].get<double>());
                    *limit = good ? stated[key].get<double>() : 0;
                }
            }
            if (!good || !(*number >= made.minimum && *number <= made.maximum)) {
                complain(name, fmt::format("the default of parameter '{}' is not between min and max", name),
                         "numbers, min <= default <= max");
            }
        } else if (stated.contains("min") || stated.contains("max")) {
            complain(name, fmt::format("parameter '{}' is no number", name), "no min and no max");
        }
        if (std::string const* const stated_ = std::get_if<std::string>(&made.initial);
            stated_ != nullptr &&
            (stated_->size() > longestText ||
             (!made.choices.empty() &&
              std::find(made.choices.begin(), made.choices.end(), *stated_) == made.choices.end()))) {
            complain(name, fmt::format("the default of parameter '{}' is none of its choices", name),
                     listed(made.choices));
        }
        manifest_.parameters.push_back(std::move(made));
    }
    void checkWithin() {
        if (manifest_.withinParameter.empty()) {
            return;
        }
        Parameter const* const parameter = manifest_.parameter(manifest_.withinParameter);
        if (parameter == nullptr || !std::holds_alternative<double>(parameter->initial) ||
            parameter->minimum < 0) {
            complain("within", fmt::format("'{}' is no distance", manifest_.withinParameter),
                     "the name of a parameter that is a number with min = 0 or more");
        }
    }

    void readStore(json const& all) {
        if (!all.contains("store")) {
            return;
        }
        json const& store = all["store"];
        onlyKeys(store, " in 'store'", {"object", "script"});
        if (!store.is_object()) {
            complain("store", "'store' is no table",
                     "store = { object = { count = 0 }, script = { total = 0 } }");
            return;
        }
        for (auto const& [key, fields] :
             {std::pair{"object", &manifest_.objectStore}, {"script", &manifest_.scriptStore}}) {
            if (!store.contains(key)) {
                continue;
            }
            if (store[key].size() > mostStoreFields) {
                complain(key, fmt::format("'{}' in 'store' has {} fields", key, store[key].size()),
                         fmt::format("at most {}", mostStoreFields));
                continue;
            }
            for (auto const& [name, initial] : store[key].items()) {
                auto const value = valueOf(initial);
                if (!isIdentifier(name) || !value || !isFinite(*value)) {
                    complain(name, fmt::format("'{}' in 'store' has no initial value", name),
                             "a number, true or false, vec2(x, y) or a text");
                } else {
                    fields->push_back({name, *value});
                }
            }
        }
        if (!manifest_.objectStore.empty() && manifest_.application == Application::once) {
            complain("store", "a script that is applied once has no object", "store = { script = ... }");
        }
    }

    /// A value that is no number in its place, in words.
    static std::string inWords(json const& value) {
        if (value.is_number()) {
            return std::isnan(value.get<double>()) ? "nan" : fmt::format("{}", value.get<double>());
        }
        return value.is_string() ? "a text" : value.is_boolean() ? "true or false" : "a table";
    }

    void readLimits(json const& all) {
        if (!all.contains("limits")) {
            return;
        }
        if (!all["limits"].is_object() && !(all["limits"].is_array() && all["limits"].empty())) {
            complain("limits", "'limits' is no table", "limits = { instructions = 60000 }");
            return;
        }
        onlyKeys(all["limits"], " in 'limits'",
                 {"instructions", "instructions_per_object", "memory", "calls", "calls_per_object",
                  "creations", "log_lines"});
        ScriptLimits const most = allowedLimits();
        auto const limit = [&](char const* key, auto& value, auto greatest, std::size_t least = 0) {
            if (!all["limits"].contains(key)) {
                return;
            }
            json const& stated = all["limits"][key];
            double const number = stated.is_number() ? stated.get<double>() : -1;
            if (!(number >= static_cast<double>(least)) || !(number <= static_cast<double>(greatest)) ||
                number != std::floor(number)) {
                complainIn("limits", key, fmt::format("'limits.{}' cannot be {}", key, inWords(stated)),
                           fmt::format("a whole number from {} to {}", least, greatest));
                return;
            }
            value = static_cast<std::remove_reference_t<decltype(value)>>(stated.get<double>());
        };
        limit("instructions", manifest_.limits.instructions, most.instructions);
        limit("instructions_per_object", manifest_.limits.instructionsPerObject, most.instructionsPerObject);
        limit("memory", manifest_.limits.memory, most.memory, leastMemory);
        limit("calls", manifest_.limits.calls, most.calls);
        limit("calls_per_object", manifest_.limits.callsPerObject, most.callsPerObject);
        limit("creations", manifest_.limits.creations, most.creations);
        limit("log_lines", manifest_.limits.logLines, most.logLines);
        // A limit of the memory in use has no effect above the limit of all that may be allocated.
        manifest_.limits.allocation = std::max(manifest_.limits.allocation, manifest_.limits.memory);
    }

    Manifest& manifest_;
};

} // namespace

void readInto(Manifest& manifest, json const& all, Problems& problems) {
    ManifestReader(manifest, problems).read(all);
}

} // namespace trembler::lua
