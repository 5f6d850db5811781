// Gathers the events of a run. Without a trace, an event costs one test of a null pointer.
#pragma once

#include "runtime/object/object_id.hpp"
#include "runtime/trace/event.hpp"

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <iosfwd>
#include <map>
#include <span>
#include <string_view>

namespace trembler {

class Store;

/// The events of one chunk of one component in one part of a frame. Used by one thread at a time. There is
/// room for 256 components, 4096 chunks, 2^26 parts of frames and 2^18 events per chunk and part; beyond it,
/// throws std::length_error.
class EventSink {
public:
    EventSink() = default;
    EventSink(Store const* store, Moment when, std::uint32_t component, std::uint32_t chunk, Phase phase,
              std::string_view name);

    /// Goes on in another part of a frame, without events. Throws as the constructor does.
    void restart(Moment when);

    EventId record(std::string_view event, std::span<ObjectId const> objects,
                   std::span<EventId const> causes);
    [[nodiscard]] std::vector<Event>& events() { return events_; }
    [[nodiscard]] std::vector<Event> const& events() const { return events_; }

private:
    Store const* store_ = nullptr;
    Moment when_;
    std::uint64_t base_ = 0;
    Phase phase_ = Phase::resolver;
    std::string_view component_;
    std::vector<Event> events_;
};

/// The account of a run. Components write into sinks of their own; gather() joins these in canonical order at
/// the end of each frame, so the account is the same for any number of threads.
class Tracer {
public:
    static constexpr std::size_t usualBytes = std::size_t{2} << 30U;

    explicit Tracer(std::size_t mostBytes = usualBytes) : mostBytes_(mostBytes) {}

    /// Moves the sink's events into the account. Call in ascending order of components and chunks. Throws
    /// std::length_error if the account then takes more memory than it may.
    void gather(EventSink& sink);
    /// Memory of all events, about.
    [[nodiscard]] std::size_t bytes() const { return bytes_; }
    /// Every event so far, ascending by id.
    [[nodiscard]] std::span<Event const> events() const { return events_; }
    [[nodiscard]] Event const* find(EventId id) const;
    /// The position of an event in the account, counted from 1: its id in files. 0 if there is none.
    [[nodiscard]] std::uint64_t number(EventId id) const;
    /// All direct and indirect causes of an event, itself included, ascending.
    [[nodiscard]] std::vector<EventId> chain(EventId id) const;
    /// Writes events from position `from` on as JSON lines.
    void write(std::ostream& out, std::size_t from = 0) const;

private:
    std::vector<Event> events_;
    std::size_t bytes_ = 0;
    std::size_t mostBytes_;
};

} // namespace trembler
