#include "game/ui/shared/kept/profile_text.hpp"

#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "runtime/file/kept_file.hpp"
#include "runtime/file/visible_text.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace trembler::ui {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array flags{std::pair{"shadows", &Settings::shadows},
                           std::pair{"shadows_chosen", &Settings::shadowsChosen},
                           std::pair{"fullscreen", &Settings::fullscreen},
                           std::pair{"names", &Settings::names},
                           std::pair{"hrtf", &Settings::hrtf},
                           std::pair{"reduced_motion", &Settings::reducedMotion},
                           std::pair{"pad_is_second", &Settings::padIsSecond},
                           std::pair{"clear_colours", &Settings::clearColours}};
constexpr std::array percents{std::pair{"volume", &Settings::volume},
                              std::pair{"interface_volume", &Settings::touches}};
constexpr char const* scaleKey = "ui_scale";
constexpr char const* languageKey = "language";
constexpr char const* keysKey = "keys";
constexpr char const* progressKey = "progress";
constexpr char const* timesKey = "changed_at";
constexpr std::string_view keysPrefix = "keys.";
constexpr std::int64_t latest = 1'000'000'000'000'000; // ms: in 30,000 years

Json const* memberOf(Json const& object, std::string_view key) {
    auto const found = object.is_object() ? object.find(std::string(key)) : object.end();
    return found == object.end() ? nullptr : &*found;
}

std::int64_t timeIn(Json const& profile, std::string const& name) {
    Json const* const times = memberOf(profile, timesKey);
    Json const* const at = times == nullptr ? nullptr : memberOf(*times, name);
    return at != nullptr && at->is_number_integer() && *at >= 0 && *at <= latest ? at->get<std::int64_t>()
                                                                                 : -1;
}

Json const* valueIn(Json const& profile, std::string const& name) {
    if (!name.starts_with(keysPrefix)) {
        return memberOf(profile, name);
    }
    Json const* const keys = memberOf(profile, keysKey);
    return keys == nullptr ? nullptr : memberOf(*keys, name.substr(keysPrefix.size()));
}

bool isListOfTexts(Json const& value) {
    return value.is_array() &&
           std::all_of(value.begin(), value.end(), [](Json const& each) { return each.is_string(); });
}

/// For example {"run": ["Space"], "redo": ["Ctrl+Y", "Ctrl+R"], "hint": []}; a damaged entry does not affect
/// the others.
void readKeys(Json const& profile, ProfileEntries& read) {
    Json const* const stated = memberOf(profile, keysKey);
    if (stated != nullptr && !stated->is_object()) {
        read.troubles.emplace_back(
            [] { return words::keysNotRead("an object, like {\"run\": [\"Space\"]}"); });
    } else if (stated != nullptr) {
        for (auto const& [id, names] : stated->items()) {
            if (isListOfTexts(names)) {
                read.values[nameOfKeys(id)] = {names,
                                               std::max<std::int64_t>(0, timeIn(profile, nameOfKeys(id)))};
            } else {
                read.troubles.emplace_back([id = id] {
                    return words::keysNotRead("\"" + id + "\" to be a list of keys, like [\"Space\"]");
                });
            }
        }
    }
    // Keys that were set back to their defaults have a time only.
    if (Json const* const times = memberOf(profile, timesKey); times != nullptr && times->is_object()) {
        for (auto const& [name, at] : times->items()) {
            if (name.starts_with(keysPrefix) && valueIn(profile, name) == nullptr &&
                timeIn(profile, name) >= 0) {
                read.values[name] = {nullptr, timeIn(profile, name)};
            }
        }
    }
}

/// `damaged` becomes the levels whose stars are damaged.
CampaignProgress progressIn(Json const& profile, std::vector<std::string>& damaged) {
    CampaignProgress progress;
    if (Json const* const solved = memberOf(profile, "solved"); solved != nullptr && solved->is_array()) {
        for (Json const& id : *solved) {
            if (id.is_string()) {
                progress.markSolved(id.get<std::string>());
            }
        }
    }
    if (Json const* const levels = memberOf(profile, progressKey)) {
        damaged = progress.read(*levels);
    }
    return progress;
}

/// A sentence for each level whose stars are damaged; of many levels for the first ones.
void tellOfDamagedStars(std::vector<std::string> const& damaged, ProfileEntries& read) {
    constexpr std::size_t most = 3;
    for (std::size_t i = 0; i < std::min(damaged.size(), most); ++i) {
        read.troubles.emplace_back(
            [level = visible(damaged[i])] { return textWith("kept.stars_not_read", level); });
    }
    if (damaged.size() > most) {
        read.troubles.emplace_back(
            [more = damaged.size() - most] { return textWith("kept.more_stars_not_read", more); });
    }
}

void setValue(Json& profile, std::string const& name, TimedValue const& timed) {
    if (!name.starts_with(keysPrefix)) {
        profile[name] = timed.value;
    } else {
        Json& keys = profile[keysKey];
        if (!keys.is_object()) {
            keys = Json::object();
        }
        if (timed.value.is_null()) {
            keys.erase(name.substr(keysPrefix.size()));
        } else {
            keys[name.substr(keysPrefix.size())] = timed.value;
        }
        if (keys.empty()) {
            profile.erase(keysKey);
        }
    }
    if (timed.at > 0) {
        Json& times = profile[timesKey];
        if (!times.is_object()) {
            times = Json::object();
        }
        times[name] = timed.at;
    }
}

} // namespace

bool isWholeProfile(std::string_view text) {
    if (!isWholeJson(text)) {
        return false;
    }
    Json const all = Json::parse(text, nullptr, false);
    Json const* const progress = memberOf(all, progressKey);
    return all.is_object() && (progress == nullptr || progress->is_object());
}

std::string nameOfKeys(std::string_view command) {
    return std::string(keysPrefix) += command;
}

std::map<std::string, Json> valuesOf(Settings const& settings) {
    std::map<std::string, Json> values{{scaleKey, settings.uiScale}, {languageKey, settings.language}};
    for (auto const& [key, member] : flags) {
        values[key] = settings.*member;
    }
    for (auto const& [key, member] : percents) {
        values[key] = settings.*member;
    }
    return values;
}

Settings settingsOf(TimedValues const& values) {
    Settings settings;
    for (auto const& [name, timed] : values) {
        for (auto const& [key, member] : flags) {
            if (name == key && timed.value.is_boolean()) {
                settings.*member = timed.value.get<bool>();
            }
        }
        for (auto const& [key, member] : percents) {
            if (name == key && timed.value.is_number()) {
                settings.*member = static_cast<int>(std::clamp(timed.value.get<double>(), 0.0, 100.0));
            }
        }
        if (name == scaleKey && timed.value.is_number()) {
            settings.uiScale = std::clamp(timed.value.get<float>(), 0.5F, 3.F);
        }
        if (name == languageKey && timed.value.is_string()) {
            settings.language = timed.value.get<std::string>();
        }
    }
    return settings;
}

StatedKeys keysOf(TimedValues const& values) {
    StatedKeys keys;
    for (auto const& [name, timed] : values) {
        if (name.starts_with(keysPrefix) && timed.value.is_array()) {
            keys[name.substr(keysPrefix.size())] = timed.value.get<std::vector<std::string>>();
        }
    }
    return keys;
}

ProfileEntries readProfile(std::string_view text) {
    ProfileEntries read;
    Json const all = Json::parse(text, nullptr, false);
    for (auto const& [name, usual] : valuesOf({})) {
        Json const* const value = memberOf(all, name);
        if (value == nullptr) {
            continue;
        }
        bool const fits = value->type() == usual.type() || (value->is_number() && usual.is_number());
        if (fits) {
            read.values[name] = {*value, std::max<std::int64_t>(0, timeIn(all, name))};
        } else {
            read.troubles.emplace_back([name = name] { return textWith("kept.setting_not_read", name); });
        }
    }
    readKeys(all, read);
    std::vector<std::string> damaged;
    read.progress = progressIn(all, damaged);
    tellOfDamagedStars(damaged, read);
    return read;
}

CampaignProgress progressOf(Json const& profile) {
    std::vector<std::string> damaged;
    return progressIn(profile, damaged);
}

std::int64_t changedAt(Json const& profile, std::string const& name) {
    std::int64_t const at = timeIn(profile, name);
    return at < 0 && valueIn(profile, name) != nullptr ? 0 : at;
}

Json withAdded(Json present, TimedValues const& values, CampaignProgress const& progress) {
    for (auto const& [name, timed] : values) {
        std::int64_t const at = changedAt(present, name);
        Json const* const there = valueIn(present, name);
        // Of two at the same time it does not matter which, but every program must decide alike.
        bool const later =
            timed.at > at || (timed.at == at && timed.at > 0 &&
                              timed.value.dump() > (there == nullptr ? "null" : there->dump()));
        if (later) {
            setValue(present, name, timed);
        }
    }
    CampaignProgress all = progressOf(present);
    all.add(progress);
    Json& levels = present[progressKey];
    levels = all.writtenInto(std::move(levels));
    return present;
}

} // namespace trembler::ui
