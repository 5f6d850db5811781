// The interface of a running component, whatever its kind, to the world.
#pragma once

#include "runtime/component/caller_id.hpp"
#include "runtime/component/info.hpp"
#include "runtime/schedule/executor.hpp"
#include "runtime/trace/tracer.hpp"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <span>

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

/// The version of a column or slot that a component reads, and the version that it has seen.
struct Watch {
    std::uint64_t const* version = nullptr;
    std::uint64_t seen = 0;
    [[nodiscard]] bool changed() const { return *version != seen; }
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
    /// Whether it certainly has no work: it has stated its watches, and none of them has changed. The world
    /// asks it of every component in every part of a frame, so it is not virtual and looks at little memory.
    /// If false, hasWork() decides.
    [[nodiscard]] bool sleeps() const {
        return waiting_ &&
               std::none_of(awaited_.begin(), awaited_.end(), [](Watch const& w) { return w.changed(); });
    }
    /// The number of rows that it reads, by which the world judges whether threads are worth their overhead.
    [[nodiscard]] virtual std::size_t workload() const = 0;
    virtual void run(FrameContext const& context) = 0;
    /// Hashes the data that it keeps between turns, and the held and waiting calls for it. Between frames.
    virtual void hashState(StateHash& hash) const = 0;
    /// The sinks of its last run, in order of chunks, and empty ones of earlier runs with more chunks.
    [[nodiscard]] std::deque<EventSink>& sinks() { return sinks_; }
    /// Whether these have events.
    [[nodiscard]] bool hasEvents() const {
        auto const has = [](EventSink const& sink) { return !sink.events().empty(); };
        return sinks_.size() == 1 ? has(sinks_.front()) : std::any_of(sinks_.begin(), sinks_.end(), has);
    }

protected:
    /// States that it has no work until one of these has changed, or until wake(). They must stay where they
    /// are until then. Without any, it waits for wake().
    void waitFor(std::span<Watch const> awaited) {
        awaited_ = awaited;
        waiting_ = true;
    }
    void wake() { waiting_ = false; }

    void openSinks(FrameContext const& context, Phase phase);

    /// Its identity as a caller; an interaction's only.
    [[nodiscard]] CallerId caller() const { return caller_; }

private:
    std::span<Watch const> awaited_; // first, so that the data that sleeps() reads is adjacent in memory
    bool waiting_ = false;

protected:
    ComponentInfo const& info_;
    std::deque<EventSink> sinks_; // a deque: references to sinks stay valid while more are added

private:
    friend class World; // sets caller_ before it binds the component
    CallerId caller_;
};

} // namespace trembler
