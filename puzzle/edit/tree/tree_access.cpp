#include "puzzle/edit/tree/tree_access.hpp"

#include "runtime/file/visible_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trembler::edit {
namespace {

constexpr std::size_t longestName = 100; // bytes

std::vector<std::string> const& levelOrder() {
    static std::vector<std::string> const keys{"$schema",  "version", "title",     "text",   "demonstration",
                                               "mods",     "world",   "objects",   "joints", "connections",
                                               "placing",  "toolbox", "goals",     "task",   "hints",
                                               "teaching", "texts",   "solutions", "editor"};
    return keys;
}

/// A key of a level in the words of a message.
std::string keyInWords(char const* key) {
    return fmt::format("\"{}\" of this level", key);
}

} // namespace

std::string objectsInWords(std::vector<std::string> const& names) {
    return names.size() == 1 ? names.front() : fmt::format("{} objects", names.size());
}

Json const* findList(Json const& level, char const* key) {
    if (!level.is_object()) {
        return nullptr;
    }
    auto const found = level.find(key);
    return found != level.end() && found->is_array() ? &*found : nullptr;
}

Json& listIn(Json& level, char const* key) {
    if (!level.contains(key)) {
        setLevelMember(level, key, Json::array());
    }
    if (!level[key].is_array()) {
        throw CommandError(fmt::format("{} is no list", keyInWords(key)));
    }
    return level[key];
}

Json& objectIn(Json& level, char const* key) {
    if (!level.contains(key)) {
        setLevelMember(level, key, Json::object());
    }
    if (!level[key].is_object()) {
        throw CommandError(fmt::format("{} is no object", keyInWords(key)));
    }
    return level[key];
}

void dropIfEmpty(Json& level, char const* key) {
    if (auto const found = level.find(key); found != level.end() && found->empty()) {
        level.erase(key);
    }
}

Json& entryIn(Json& level, char const* key, std::size_t index) {
    mustHaveEntry(level, key, index, "entry");
    return level[key][index];
}

void mustHaveEntry(Json const& level, char const* key, std::size_t index, std::string_view what) {
    Json const* const list = findList(level, key);
    if (list == nullptr || index >= list->size()) {
        throw CommandError(fmt::format("there is no {} {} under {}", what, index + 1, keyInWords(key)));
    }
}

void moveEntry(Json& level, char const* key, std::size_t from, std::size_t to) {
    mustHaveEntry(level, key, from, "entry");
    mustHaveEntry(level, key, to, "entry");
    auto& list = level[key].get_ref<Json::array_t&>();
    auto const at = [&](std::size_t index) { return list.begin() + static_cast<std::ptrdiff_t>(index); };
    if (from < to) {
        std::rotate(at(from), at(from + 1), at(to + 1));
    } else {
        std::rotate(at(to), at(from), at(from + 1));
    }
}

Json& objectEntry(Json& level, std::string const& name) {
    if (Json const* const list = findList(level, "objects"); list != nullptr) {
        for (Json& entry : level["objects"]) {
            if (textOf(entry, "name") == name) {
                return entry;
            }
        }
    }
    throw CommandError(fmt::format("there is no object '{}'", name));
}

ObjectEntries::ObjectEntries(Json& level) {
    if (findList(level, "objects") == nullptr) {
        return;
    }
    for (Json& entry : level["objects"]) {
        auto const name = entry.is_object() ? entry.find("name") : entry.end();
        if (name != entry.end() && name->is_string()) {
            entries_.emplace(name->get_ref<std::string const&>(), &entry); // the first of that name
        }
    }
}

Json& ObjectEntries::of(std::string const& name) const {
    auto const found = entries_.find(name);
    if (found == entries_.end()) {
        throw CommandError(fmt::format("there is no object '{}'", name));
    }
    return *found->second;
}

void mustHaveObjects(Json const& level, std::vector<std::string> const& names) {
    if (names.empty()) {
        throw CommandError("no object is selected");
    }
    std::set<std::string> known;
    if (Json const* const list = findList(level, "objects"); list != nullptr) {
        for (Json const& entry : *list) {
            known.insert(textOf(entry, "name"));
        }
    }
    for (std::string const& name : names) {
        if (name.empty() || !known.contains(name)) {
            throw CommandError(fmt::format("there is no object '{}'", name));
        }
    }
}

std::string textOf(Json const& object, char const* key) {
    if (!object.is_object()) {
        return {};
    }
    auto const found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

void setMember(Json& entry, std::string const& key, Json value, std::vector<std::string> const& order) {
    if (entry.is_null()) {
        entry = Json::object();
    }
    if (auto const found = entry.find(key); found != entry.end()) {
        *found = std::move(value);
        return;
    }
    auto const rank = [&](std::string const& of) {
        return std::find(order.begin(), order.end(), of) - order.begin();
    };
    auto const& members = entry.get_ref<Json::object_t const&>();
    // After the last member that usually precedes it: a file may have an order of its own.
    std::size_t place = 0;
    for (std::size_t i = 0; i < members.size(); ++i) {
        if (rank(members.data()[i].first) <= rank(key)) {
            place = i + 1;
        }
    }
    Json made = Json::object();
    auto& to = made.get_ref<Json::object_t&>();
    for (std::size_t i = 0; i <= members.size(); ++i) {
        if (i == place) {
            to.push_back({key, std::move(value)});
        }
        if (i < members.size()) {
            to.push_back(members.data()[i]);
        }
    }
    entry = std::move(made);
}

void setObjectMember(Json& entry, std::string const& key, Json value) {
    static std::vector<std::string> const order{"name",    "part",       "at",    "angle_deg",
                                                "flipped", "properties", "pieces"};
    setMember(entry, key, std::move(value), order);
}

void setLevelMember(Json& level, std::string const& key, Json value) {
    setMember(level, key, std::move(value), levelOrder());
}

Json numberJson(double number) {
    if (!std::isfinite(number)) {
        throw CommandError("a number is too large");
    }
    constexpr double unit = 1e9;
    constexpr double exact = 1e6; // beyond, rounding to 1e-9 is below the precision of a double
    double const rounded = std::abs(number) <= exact ? std::round(number * unit) / unit : number;
    if (rounded == std::floor(rounded) && std::abs(rounded) < 1e15) {
        return static_cast<std::int64_t>(rounded);
    }
    return rounded;
}

Json pointJson(Vec2 point) {
    return Json::array({numberJson(point.x), numberJson(point.y)});
}

double numberOf(Json const& value) {
    return value.is_number() ? value.get<double>() : 0.0;
}

std::optional<Vec2> pointOf(Json const& value) {
    if (!value.is_array() || value.size() != 2 || !value[0].is_number() || !value[1].is_number()) {
        return std::nullopt;
    }
    return Vec2{numberOf(value[0]), numberOf(value[1])};
}

Vec2 placeOf(Json const& entry) {
    auto const at = entry.is_object() ? entry.find("at") : entry.end();
    return at == entry.end() ? Vec2{} : pointOf(*at).value_or(Vec2{});
}

double angleOf(Json const& entry) {
    auto const angle = entry.is_object() ? entry.find("angle_deg") : entry.end();
    return angle == entry.end() ? 0.0 : numberOf(*angle);
}

void setPlace(Json& entry, Vec2 at) {
    setObjectMember(entry, "at", pointJson(at));
}

void setAngle(Json& entry, double degrees) {
    constexpr double unit = 1e6;
    double const rounded = std::round(degrees * unit) / unit;
    if (rounded == 0) {
        if (angleOf(entry) != 0) { // a 0 that the author wrote stays
            entry.erase("angle_deg");
        }
    } else {
        setObjectMember(entry, "angle_deg", numberJson(rounded));
    }
}

std::set<std::string> takenNames(Json const& level) {
    std::set<std::string> taken{"world"};
    for (char const* const key : {"objects", "joints"}) {
        if (Json const* const list = findList(level, key); list != nullptr) {
            for (Json const& entry : *list) {
                taken.insert(textOf(entry, "name"));
            }
        }
    }
    return taken;
}

std::string untaken(std::set<std::string> const& taken, std::string const& wanted) {
    if (!wanted.empty() && !taken.contains(wanted)) {
        return wanted;
    }
    std::string base = wanted.empty() ? "object" : wanted;
    std::size_t const digits = base.find_last_not_of("0123456789");
    if (digits != std::string::npos && digits + 1 < base.size() && base[digits] == ' ' && digits > 0) {
        base.resize(digits);
    }
    constexpr std::size_t roomForNumber = 12;
    if (base.size() > longestName - roomForNumber) {
        std::size_t cut = longestName - roomForNumber;
        while (cut > 0 && (static_cast<unsigned char>(base[cut]) & 0xC0U) == 0x80U) {
            --cut; // do not cut inside a character
        }
        base.resize(cut);
        base.erase(base.find_last_not_of(' ') + 1);
    }
    for (std::size_t number = 2;; ++number) {
        if (std::string name = fmt::format("{} {}", base, number); !taken.contains(name)) {
            return name;
        }
    }
}

void mustBeName(std::string const& name, std::string_view what) {
    if (name.empty() || name.size() > longestName || hasControlCharacter(name) || name.front() == ' ' ||
        name.back() == ' ') {
        throw CommandError(fmt::format("{} must have 1 to {} bytes in one line, without blanks at its ends",
                                       what, longestName));
    }
}

} // namespace trembler::edit
