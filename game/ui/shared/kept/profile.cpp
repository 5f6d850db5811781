#include "game/ui/shared/kept/profile.hpp"

#include "game/ui/shared/words.hpp"
#include "runtime/file/output_file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <system_error>

namespace trembler::ui {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Keys = std::map<std::string, std::vector<std::string>>;

/// For example {"run": ["Space"], "redo": ["Ctrl+Y", "Ctrl+R"], "hint": []}; a damaged entry does not affect
/// the others.
Keys readKeys(Json const& stated, std::vector<std::string>& troubles) {
    Keys keys;
    if (!stated.is_object()) {
        troubles.push_back(words::keysNotRead("an object, like {\"run\": [\"Space\"]}"));
        return keys;
    }
    for (auto const& [id, names] : stated.items()) {
        auto const isText = [](Json const& name) { return name.is_string(); };
        if (!names.is_array() || !std::all_of(names.begin(), names.end(), isText)) {
            troubles.push_back(words::keysNotRead("\"" + id + "\" to be a list of keys, like [\"Space\"]"));
            continue;
        }
        keys[id] = names.get<std::vector<std::string>>();
    }
    return keys;
}

} // namespace

Profile::Profile(fs::path file) : file_(std::move(file)) {
    read();
}

void Profile::setSettings(Settings const& settings) {
    settings_ = settings;
    settings_.uiScale = std::clamp(settings.uiScale, 0.5F, 3.F);
    settings_.volume = std::clamp(settings.volume, 0, 100);
    settings_.touches = std::clamp(settings.touches, 0, 100);
    write();
}

void Profile::setKeys(Keys keys) {
    keys_ = std::move(keys);
    write();
}

bool Profile::markSolved(std::string const& levelId) {
    bool const fresh = progress_.markSolved(levelId);
    if (fresh) {
        write();
    }
    return fresh;
}

bool Profile::addKind(std::string const& levelId, SolutionKind kind) {
    bool const fresh = progress_.addKind(levelId, std::move(kind));
    if (fresh) {
        write();
    }
    return fresh;
}

fs::path Profile::usualFile() {
    if (char const* const data = std::getenv("XDG_DATA_HOME"); data != nullptr && *data != '\0') {
        return fs::path(data) / "trembler" / "profile.json";
    }
    if (char const* const home = std::getenv("HOME"); home != nullptr && *home != '\0') {
        return fs::path(home) / ".local" / "share" / "trembler" / "profile.json";
    }
    return {};
}

void Profile::read() {
    std::ifstream in(file_);
    if (file_.empty() || !in) {
        return;
    }
    Json const all = Json::parse(in, nullptr, false);
    if (!all.is_object()) {
        return;
    }
    // Each value by itself: a damaged one must not affect the others.
    auto const flag = [&](char const* key, bool usual) {
        auto const found = all.find(key);
        return found != all.end() && found->is_boolean() ? found->get<bool>() : usual;
    };
    if (auto const scale = all.find("ui_scale"); scale != all.end() && scale->is_number()) {
        settings_.uiScale = std::clamp(scale->get<float>(), 0.5F, 3.F);
    }
    settings_.shadows = flag("shadows", settings_.shadows);
    settings_.shadowsChosen = flag("shadows_chosen", settings_.shadowsChosen);
    settings_.fullscreen = flag("fullscreen", settings_.fullscreen);
    settings_.names = flag("names", settings_.names);
    settings_.hrtf = flag("hrtf", settings_.hrtf);
    settings_.reducedMotion = flag("reduced_motion", settings_.reducedMotion);
    settings_.padIsSecond = flag("pad_is_second", settings_.padIsSecond);
    settings_.clearColours = flag("clear_colours", settings_.clearColours);
    auto const percent = [&](char const* key, int usual) {
        auto const found = all.find(key);
        bool const number = found != all.end() && found->is_number();
        return number ? static_cast<int>(std::clamp(found->get<double>(), 0.0, 100.0)) : usual;
    };
    settings_.volume = percent("volume", settings_.volume);
    settings_.touches = percent("interface_volume", settings_.touches);
    if (auto const language = all.find("language"); language != all.end() && language->is_string()) {
        settings_.language = language->get<std::string>();
    }
    if (auto const keys = all.find("keys"); keys != all.end()) {
        keys_ = readKeys(*keys, troubles_);
    }
    if (auto const solved = all.find("solved"); solved != all.end() && solved->is_array()) {
        for (Json const& id : *solved) {
            if (id.is_string()) {
                progress_.markSolved(id.get<std::string>());
            }
        }
    }
    if (auto const progress = all.find("progress"); progress != all.end()) {
        progress_.read(*progress);
    }
}

void Profile::write() const {
    if (file_.empty()) {
        return;
    }
    std::error_code ignored;
    fs::create_directories(file_.parent_path(), ignored);
    Json all{{"ui_scale", settings_.uiScale},
             {"shadows", settings_.shadows},
             {"shadows_chosen", settings_.shadowsChosen},
             {"fullscreen", settings_.fullscreen},
             {"names", settings_.names},
             {"volume", settings_.volume},
             {"interface_volume", settings_.touches},
             {"hrtf", settings_.hrtf},
             {"reduced_motion", settings_.reducedMotion},
             {"pad_is_second", settings_.padIsSecond},
             {"clear_colours", settings_.clearColours},
             {"language", settings_.language},
             {"progress", progress_.written()}};
    if (!keys_.empty()) {
        all["keys"] = keys_;
    }
    // The file is replaced atomically: a crash while writing must not lose the player's progress.
    try {
        writeFile(file_, all.dump(2) + "\n");
    } catch (OutputError const&) { // the previous file stays
    }
}

} // namespace trembler::ui
