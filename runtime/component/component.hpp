// The interface of a running component, whatever its kind, to the world.
#pragma once

#include "runtime/component/caller_id.hpp"
#include "runtime/component/info.hpp"
#include "runtime/schedule/executor.hpp"
#include "runtime/trace/tracer.hpp"

#include <deque>

namespace trembler {

class Store;
class Channels;
class StateHash;

/// Length of a frame, in seconds. Fixed: a replay must not depend on the speed of a machine. A component's
/// turn may cover a part of a frame or several frames: that time is AccessBase::duration().
inline constexpr double frameDuration = 1.0 / 60.0;

enum class Activity : std::uint8_t {
    absent, ///< not constructed: see ChoiceReason for the reasons
    asleep, ///< nothing that it reads has changed since it last ran
    active,
};
[[nodiscard]] std::string_view nameOf(Activity activity);

/// The world's data for one turn of one component, in one part of a frame.
struct FrameContext {
    Moment when;
    double duration = frameDuration; ///< s since the component's last turn
    Executor* executor = nullptr;
    Store const* store = nullptr;
    bool tracing = false;
    std::uint32_t component = 0; ///< its index: resolvers, then derived property sets, then interactions
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
    /// The number of rows that it reads, by which the world judges whether threads are worth their overhead.
    [[nodiscard]] virtual std::size_t workload() const = 0;
    virtual void run(FrameContext const& context) = 0;
    /// Hashes the data that it keeps between turns, and the held and waiting calls for it. Between frames.
    virtual void hashState(StateHash& hash) const = 0;
    /// The sinks of its last run, in order of chunks.
    [[nodiscard]] std::deque<EventSink>& sinks() { return sinks_; }

protected:
    void openSinks(FrameContext const& context, std::size_t chunks, Phase phase);

    /// Its identity as a caller; an interaction's only.
    [[nodiscard]] CallerId caller() const { return caller_; }

    ComponentInfo const& info_;
    std::deque<EventSink> sinks_; // a deque: references to sinks stay valid while more are added

private:
    friend class World; // sets caller_ before it binds the component
    CallerId caller_;
};

} // namespace trembler
