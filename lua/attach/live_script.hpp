// A scripted interaction whose text, parameters and switch can change while worlds run.
#pragma once

#include "lua/binding/script.hpp"
#include "lua/component/script_log.hpp"
#include "lua/component/scripted_interaction.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace trembler::lua {

/// A script in a registry: the version in use, and the components that were made of it. Reading
/// it is thread-safe while it is not changed. It may be changed only between the frames of all worlds that
/// have a component of it, and from one thread at a time.
class LiveScript : public std::enable_shared_from_this<LiveScript> {
public:
    /// `script` must have an info, see declare().
    LiveScript(std::shared_ptr<Script const> script, std::shared_ptr<ScriptLog> log);

    /// The present version. The reference is valid until the next change.
    [[nodiscard]] Script const& script() const { return *script_; }
    [[nodiscard]] std::shared_ptr<Script const> shared() const { return script_; }
    [[nodiscard]] std::string const& name() const { return name_; }
    [[nodiscard]] std::string const& mod() const { return mod_; }
    [[nodiscard]] std::filesystem::path file() const { return script_->manifest.file; }
    /// The description that the registry has; it changes with the version.
    [[nodiscard]] ComponentInfo const& info() const { return info_; }
    /// A component for a new world.
    [[nodiscard]] std::unique_ptr<Component> make();

    /// Sets another version, of the same name and resolver, for worlds that are made from now on. Existing
    /// components keep theirs.
    void publish(std::shared_ptr<Script const> script);
    /// Makes all existing components use the present version, see ScriptedInteraction::replace(). False if
    /// there are no components.
    bool swapIn();
    /// Switches the script off, or on again, in all worlds that exist and that are made from now on.
    void setOn(bool on);
    [[nodiscard]] bool on() const { return on_; }

    /// The usage of the component that was made last, if it exists and has had a turn that did not fail.
    [[nodiscard]] std::optional<TurnUsage> usage() const;
    /// Whether the component that was made last exists and was switched off because it failed.
    [[nodiscard]] bool failed() const;

private:
    class Instance;
    void setInfo();

    std::shared_ptr<Script const> script_;
    std::shared_ptr<ScriptLog> log_;
    std::string name_; // the name to which the description refers; it outlives single versions
    std::string mod_;
    std::string text_;
    ComponentInfo info_;
    bool on_ = true;
    mutable std::mutex mutex_; // of instances_: worlds may be made by several threads
    std::vector<Instance*> instances_;
};

/// The scripts of a registry, and the data needed to read other versions of them.
class LiveScripts {
public:
    explicit LiveScripts(Vocabulary vocabulary) : vocabulary_(std::move(vocabulary)) {}

    void add(std::shared_ptr<LiveScript> script) { all_.push_back(std::move(script)); }
    /// In order of registration.
    [[nodiscard]] std::vector<std::shared_ptr<LiveScript>> const& all() const { return all_; }
    /// The script of that name, or nullptr.
    [[nodiscard]] LiveScript* find(std::string_view name) const;
    [[nodiscard]] Vocabulary const& vocabulary() const { return vocabulary_; }

    /// Reads a text as another version of a script; nullptr if it has errors. Adds these to `problems`, with
    /// file and line. Another name or resolver is an error, as these cannot change in a registry.
    [[nodiscard]] std::shared_ptr<Script const> read(LiveScript const& script, std::string text,
                                                     Problems& problems) const;
    /// A version with other defaults of its parameters. Defaults of unknown parameters, and those of another
    /// kind or out of range, are left out.
    [[nodiscard]] std::shared_ptr<Script const> with(Script const& script,
                                                     std::map<std::string, Value> const& defaults) const;

private:
    Vocabulary vocabulary_;
    std::vector<std::shared_ptr<LiveScript>> all_;
};

} // namespace trembler::lua
