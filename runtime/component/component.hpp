// What the world sees of a running component, whatever its kind.
#pragma once

#include "runtime/component/info.hpp"
#include "runtime/schedule/executor.hpp"
#include "runtime/trace/tracer.hpp"

#include <deque>

namespace trembler {

class Store;
class Channels;
class StateHash;

/// Length of a frame, in seconds. Fixed: a replay must not depend on how fast anybody's machine is. It is not
/// the time that a component's turn covers, which may be a part of a frame, or several frames: that is
/// AccessBase::duration().
inline constexpr double frameDuration = 1.0 / 60.0;

enum class Activity : std::uint8_t {
    absent, ///< not constructed: no object calls for it
    asleep, ///< nothing that it reads has changed since it last ran
    active,
};
[[nodiscard]] std::string_view nameOf(Activity activity);

/// What one component is given for one turn: in one part of a frame.
struct FrameContext {
    Moment when;
    double duration = frameDuration; ///< s since the component's last turn
    Executor* executor = nullptr;
    Store const* store = nullptr;
    bool tracing = false;
    std::uint32_t component = 0; ///< its place in the order of registration
};

class Component {
public:
    explicit Component(ComponentInfo const& info) : info_(info) {}
    virtual ~Component() = default;
    Component(Component const&) = delete;
    Component& operator=(Component const&) = delete;

    [[nodiscard]] ComponentInfo const& info() const { return info_; }
    /// Finds the columns, slots and calls that the component declared.
    virtual void bind(Store& store, Channels& channels) = 0;
    /// Whether running it now could have any effect.
    [[nodiscard]] virtual bool hasWork() const = 0;
    /// Rows that it reads: tells the world whether threads are worth their overhead.
    [[nodiscard]] virtual std::size_t workload() const = 0;
    virtual void run(FrameContext const& context) = 0;
    /// Hashes what it keeps from one turn to the next and what waits for its next one. Between frames.
    virtual void hashState(StateHash& hash) const = 0;
    /// The sinks of its last run, in order of chunks.
    [[nodiscard]] std::deque<EventSink>& sinks() { return sinks_; }

protected:
    void openSinks(FrameContext const& context, std::size_t chunks, Phase phase);

    /// Who it is to those whom it calls.
    [[nodiscard]] CallerId caller() const { return caller_; }

    ComponentInfo const& info_;
    std::deque<EventSink> sinks_; // a deque: callers hold on to theirs while more are added

private:
    friend class World; // which says who it is, before it binds it
    CallerId caller_;
};

} // namespace trembler
