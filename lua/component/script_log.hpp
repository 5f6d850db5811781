// Messages of scripts for people, from any world and thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace trembler::lua {

struct ScriptMessage {
    std::string script;
    std::uint64_t frame = 0;
    bool error = false; ///< the script is switched off for the rest of its world's run
    std::string text;
    std::string traceback; ///< of an error
};

/// Gathers the messages of all scripts of one registry. No world depends on it. Thread-safe.
class ScriptLog {
public:
    void add(ScriptMessage message) {
        std::lock_guard const lock(mutex_);
        if (messages_.size() < most) {
            messages_.push_back(std::move(message));
        }
    }
    /// The messages since the last call, in the order in which they came.
    [[nodiscard]] std::vector<ScriptMessage> take() {
        std::lock_guard const lock(mutex_);
        return std::exchange(messages_, {});
    }

    /// A script has been applied to something.
    void noteApplied(std::string const& script) {
        std::lock_guard const lock(mutex_);
        applied_.insert(script);
    }
    /// Whether it ever was, in any world.
    [[nodiscard]] bool everApplied(std::string const& script) const {
        std::lock_guard const lock(mutex_);
        return applied_.contains(script);
    }

private:
    static constexpr std::size_t most = 1000; // if no reader takes them
    mutable std::mutex mutex_;
    std::vector<ScriptMessage> messages_;
    std::set<std::string> applied_;
};

} // namespace trembler::lua
