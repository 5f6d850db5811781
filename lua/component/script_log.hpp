// Messages of scripts for people, from any world and thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
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

private:
    static constexpr std::size_t most = 1000; // if no reader takes them
    std::mutex mutex_;
    std::vector<ScriptMessage> messages_;
};

} // namespace trembler::lua
