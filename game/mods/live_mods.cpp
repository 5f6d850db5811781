#include "game/mods/live_mods.hpp"

#include "lua/attach/parameter_value.hpp"
#include "lua/attach/scripts_property.hpp"
#include "lua/sandbox/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace trembler {
namespace {

constexpr double lookEvery = 0.25; // s
constexpr std::size_t mostLines = 60;

constexpr char const* replacedWhy =
    "A script was replaced in this run, so it counts as no solution: begin it again.";
constexpr char const* switchedWhy =
    "A script was switched on or off in the Mods panel, so this run counts as no solution.";
constexpr char const* tunedWhy =
    "A script has other parameters than the level states, so this run counts as no solution.";

std::vector<std::string> allProblems(Problems const& problems) {
    std::vector<std::string> all;
    try {
        problems.throwIfAny();
    } catch (InputError const& error) {
        for (Diagnostic const& diagnostic : error.diagnostics()) {
            all.push_back(diagnostic.print());
        }
    }
    return all;
}

template <class Scripts>
auto* useIn(Scripts& scripts, std::string const& name) {
    auto const at = std::find_if(scripts.uses.begin(), scripts.uses.end(),
                                 [&](lua::ScriptUse const& use) { return use.script == name; });
    return at == scripts.uses.end() ? nullptr : &*at;
}

} // namespace

LiveMods::LiveMods(GameData const& gameData, Session& session) : gameData_(gameData), session_(session) {
    std::vector<std::filesystem::path> paths;
    for (auto const& live : gameData.scripts->all()) {
        auto const mod = std::find_if(gameData.mods.begin(), gameData.mods.end(),
                                      [&](lua::Mod const& one) { return one.name == live->mod(); });
        ModScript& script = scripts_.emplace_back();
        script.live = live;
        script.mod = mod == gameData.mods.end() ? nullptr : &*mod;
        files_.push_back(live->shared());
        paths.push_back(live->file());
    }
    if (!scripts_.empty()) {
        watch_ = std::make_unique<FileWatch>(std::move(paths), lua::longestSource);
        session_.whenBuilt([this] { worldBuilt(); });
    }
}

LiveMods::~LiveMods() {
    if (!scripts_.empty()) {
        session_.whenBuilt({});
    }
}

std::vector<ModMessage> LiveMods::takeNews() {
    return std::exchange(news_, {});
}

void LiveMods::pass(double seconds) {
    if (scripts_.empty()) {
        return;
    }
    collect();
    sinceLook_ += seconds;
    if (sinceLook_ >= lookEvery) {
        sinceLook_ = 0;
        look();
    }
}

void LiveMods::collect() {
    for (lua::ScriptMessage& message : gameData_.scriptLog->take()) {
        auto const at = std::find_if(scripts_.begin(), scripts_.end(), [&](ModScript const& script) {
            return script.live->name() == message.script;
        });
        if (at == scripts_.end()) {
            continue;
        }
        if (!message.error) {
            at->log.push_back(std::move(message.text));
            if (at->log.size() > mostLines) {
                at->log.pop_front();
            }
        } else if (!at->failure) { // once in a run
            tell(fmt::format("{} is switched off: {}", message.script, message.text), true);
            at->failure = std::move(message);
        }
    }
}

void LiveMods::look() {
    if (watch_ == nullptr) {
        return;
    }
    for (FileWatch::Change const& change : watch_->look()) {
        reload(change.file, change);
    }
}

void LiveMods::reload(std::size_t number, FileWatch::Change const& change) {
    ModScript& script = scripts_[number];
    Problems problems;
    std::shared_ptr<lua::Script const> made;
    if (!change.text) {
        problems.add({.file = script.live->file().string(),
                      .path = "",
                      .message = "cannot be read any more",
                      .expected = "the script"});
    } else {
        made = gameData_.scripts->read(*script.live, *change.text, problems);
    }
    script.refused = allProblems(problems);
    if (made != nullptr) {
        auto const before = std::exchange(files_[number], made);
        std::erase_if(script.defaults, [&](auto const& entry) {
            lua::Parameter const* const declared = made->manifest.parameter(entry.first);
            return declared == nullptr || lua::faultOf(*declared, entry.second).has_value();
        });
        if (auto const why = put(number, gameData_.scripts->with(*made, script.defaults))) {
            files_[number] = before;
            script.refused = {*why};
        }
    }
    std::string const file = script.live->file().filename().string();
    if (!script.refused.empty()) {
        tell(fmt::format("{} is not used, the version before goes on: {}", file, script.refused.front()),
             true);
        return;
    }
    ++script.saved;
    script.failure.reset();
    tell(fmt::format("{} is in use as it was saved", file));
}

std::optional<std::string> LiveMods::put(std::size_t number, std::shared_ptr<lua::Script const> made) {
    lua::LiveScript& live = *scripts_[number].live;
    auto const before = live.shared();
    live.publish(std::move(made));
    if (auto fault = session_.whyNotBuilt()) {
        live.publish(before);
        return fault;
    }
    if (session_.mode() == SessionMode::building) {
        session_.rebuild(); // so that it is there, or not, as its new declarations say
        return std::nullopt;
    }
    live.swapIn();
    wantReads();
    session_.alter(replacedWhy);
    return std::nullopt;
}

// A world computes the properties that its scripts read when it was built. Properties that they read since
// then must be computed, too.
void LiveMods::wantReads() {
    reads_.clear();
    for (ModScript const& script : scripts_) {
        for (PropertyInfo const* const read : script.live->info().reads) {
            if (read->kind != PropertyKind::object) {
                reads_.push_back(session_.world().want(*read));
            }
        }
    }
}

void LiveMods::worldBuilt() {
    reads_.clear();
    for (std::size_t i = 0; i < scripts_.size(); ++i) {
        scripts_[i].failure.reset();
        if (!scripts_[i].live->on()) {
            session_.alter(switchedWhy);
        } else if (changed(i)) {
            session_.alter(tunedWhy);
        }
    }
    for (Tuned const& tuned : tuned_) {
        apply(tuned);
    }
}

void LiveMods::setOn(std::size_t number, bool on) {
    ModScript& script = scripts_[number];
    if (on == script.live->on()) {
        return;
    }
    script.live->setOn(on);
    if (session_.mode() == SessionMode::building) {
        session_.rebuild();
    } else {
        session_.alter(switchedWhy);
    }
}

void LiveMods::setDefault(std::size_t number, std::string const& parameter, lua::Value const& value) {
    ModScript& script = scripts_[number];
    lua::Parameter const* const declared = files_[number]->manifest.parameter(parameter);
    if (declared == nullptr || lua::faultOf(*declared, value)) {
        return;
    }
    if (value == declared->initial) {
        script.defaults.erase(parameter);
    } else {
        script.defaults[parameter] = value;
    }
    script.live->publish(gameData_.scripts->with(*files_[number], script.defaults));
    script.live->swapIn();
    session_.alter(tunedWhy);
}

void LiveMods::setFor(std::size_t number, LastingObject const& object, std::string const& parameter,
                      lua::Value const& value) {
    lua::Parameter const* const declared = files_[number]->manifest.parameter(parameter);
    if (declared == nullptr || lua::faultOf(*declared, value)) {
        return;
    }
    auto at = std::find_if(tuned_.begin(), tuned_.end(), [&](Tuned const& tuned) {
        return tuned.script == number && tuned.object == object && tuned.parameter == parameter;
    });
    if (at == tuned_.end()) {
        ObjectId const id = session_.find(object);
        lua::Scripts const* const scripts = id.valid() ? session_.world().find<lua::Scripts>(id) : nullptr;
        lua::ScriptUse const* const use =
            scripts == nullptr ? nullptr : useIn(*scripts, scripts_[number].live->name());
        if (use == nullptr) {
            return;
        }
        at = tuned_.insert(tuned_.end(),
                           Tuned{number, object, parameter, value, lua::valueFor(use, *declared)});
    }
    at->value = value;
    apply(*at);
}

void LiveMods::apply(Tuned const& tuned) {
    ObjectId const id = session_.find(tuned.object);
    std::string const& name = scripts_[tuned.script].live->name();
    session_.alter(tunedWhy, [&](World& world) {
        auto& column = world.store().column<lua::Scripts>();
        lua::Scripts const* const stated = id.valid() ? column.find(id) : nullptr;
        if (stated == nullptr) {
            return;
        }
        lua::Scripts changed = *stated;
        if (lua::ScriptUse* const use = useIn(changed, name)) {
            std::erase_if(use->settings, [&](lua::ScriptSetting const& setting) {
                return setting.parameter == tuned.parameter;
            });
            use->settings.push_back(lua::settingOf(tuned.parameter, tuned.value));
            column.set(id, std::move(changed));
        }
    });
}

void LiveMods::asStated(std::size_t number) {
    if (!changed(number)) {
        return;
    }
    ModScript& script = scripts_[number];
    script.defaults.clear();
    script.live->setOn(true);
    script.live->publish(files_[number]);
    script.live->swapIn();
    for (Tuned& tuned : tuned_) {
        if (tuned.script == number) {
            tuned.value = tuned.stated;
            apply(tuned);
        }
    }
    std::erase_if(tuned_, [&](Tuned const& tuned) { return tuned.script == number; });
    if (session_.mode() == SessionMode::building) {
        session_.rebuild(); // a world that counts
    }
}

bool LiveMods::changed(std::size_t number) const {
    ModScript const& script = scripts_[number];
    return !script.live->on() || !script.defaults.empty() ||
           std::any_of(tuned_.begin(), tuned_.end(),
                       [&](Tuned const& tuned) { return tuned.script == number; });
}

std::vector<ScriptUser> LiveMods::users(std::size_t number) const {
    std::vector<ScriptUser> all;
    lua::LiveScript const& live = *scripts_[number].live;
    Store const& store = session_.world().store();
    auto const* const column = store.findColumn<lua::Scripts>();
    if (column == nullptr) {
        return all;
    }
    for (ObjectId const id : column->owners()) {
        lua::Scripts const& scripts = (*column)[id];
        lua::ScriptUse const* const use = useIn(scripts, live.name());
        if (use == nullptr) {
            continue;
        }
        ScriptUser& user = all.emplace_back();
        user.object = session_.lasting(id);
        user.name = store.nameOf(id);
        for (lua::Parameter const& parameter : live.script().manifest.parameters) {
            user.values[parameter.name] = lua::valueFor(use, parameter);
        }
    }
    return all;
}

} // namespace trembler
