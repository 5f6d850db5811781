#include "game/ui/shared/kept/profile.hpp"

#include "game/ui/shared/kept/kept_words.hpp"
#include "game/ui/shared/shown_faults.hpp"
#include "runtime/file/data_folder.hpp"
#include "runtime/file/kept_file.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace trembler::ui {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::int64_t millisecondsNow() {
    using namespace std::chrono;
    return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

} // namespace

Profile::Profile(fs::path file, Clock clock)
    : file_(std::move(file)), clock_(clock ? std::move(clock) : millisecondsNow) {
    read();
}

void Profile::setSettings(Settings const& settings) {
    auto const before = valuesOf(settings_);
    settings_ = settings;
    settings_.uiScale = std::clamp(settings.uiScale, 0.5F, 3.F);
    settings_.volume = std::clamp(settings.volume, 0, 100);
    settings_.touches = std::clamp(settings.touches, 0, 100);
    for (auto& [name, value] : valuesOf(settings_)) {
        if (value != before.at(name)) {
            change(name, value);
        }
    }
    write();
}

void Profile::setKeys(StatedKeys keys) {
    for (auto const& [id, names] : keys_) {
        if (!keys.contains(id)) {
            change(nameOfKeys(id), nullptr);
        }
    }
    for (auto const& [id, names] : keys) {
        auto const before = keys_.find(id);
        if (before == keys_.end() || before->second != names) {
            change(nameOfKeys(id), names);
        }
    }
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
    return inDataFolder("profile.json");
}

void Profile::read() {
    if (file_.empty()) {
        return;
    }
    KeptText found;
    try {
        found = KeptFile(file_, isWholeProfile).read();
    } catch (InputError const& error) {
        troubles_.emplace_back([error] { return notReadable(error); });
        return;
    }
    if (found.damaged) {
        troubles_.emplace_back([damaged = *found.damaged] { return inWords(damaged); });
    }
    if (found.text) {
        ProfileEntries entries = readProfile(*found.text);
        values_ = std::move(entries.values);
        progress_ = std::move(entries.progress);
        troubles_.insert(troubles_.end(), entries.troubles.begin(), entries.troubles.end());
    }
    settings_ = settingsOf(values_);
    keys_ = keysOf(values_);
}

std::vector<std::string> Profile::troubles() const {
    std::vector<std::string> sentences;
    for (auto const& sentence : troubles_) {
        sentences.push_back(sentence());
    }
    return sentences;
}

void Profile::change(std::string const& name, Json value) {
    TimedValue& timed = values_[name];
    timed = {std::move(value), std::max(clock_(), timed.at + 1)};
    chosen_.insert(name);
}

void Profile::write() {
    sinceTry_ = 0;
    if (file_.empty()) {
        return;
    }
    auto const added = [this](KeptText const& there) {
        Json present = there.text ? Json::parse(*there.text, nullptr, false) : Json::object();
        // The clock may have been wrong once: what the player chooses now is later in any case.
        for (std::string const& name : chosen_) {
            TimedValue& timed = values_[name];
            timed.at = std::max(timed.at, changedAt(present, name) + 1);
        }
        Json all = withAdded(std::move(present), values_, progress_);
        progress_.add(progressOf(all));
        std::string indented = all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
        return indented.size() <= limits::fileSize
                   ? indented
                   : all.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    };
    try {
        KeptFile(file_, isWholeProfile).change(added);
        chosen_.clear();
        unwritten_.reset();
    } catch (OutputError const& error) {
        unwritten_ = error;
    }
}

void Profile::pass(double seconds) {
    sinceTry_ += seconds;
    if (unwritten_ && sinceTry_ >= patience) {
        write();
    }
}

void Profile::finish() {
    if (unwritten_) {
        write();
    }
}

} // namespace trembler::ui
