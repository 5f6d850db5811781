#include "runtime/trace/tracer.hpp"

#include "runtime/file/visible_text.hpp"
#include "runtime/world/store.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cassert>
#include <ostream>
#include <set>
#include <stdexcept>

namespace trembler {
namespace {

// part of a frame : 26 | component : 8 | chunk : 12 | sequence : 18, most significant first, so ids sort in
// the order of events.
constexpr unsigned stepShift = 38;
constexpr unsigned componentShift = 30;
constexpr unsigned chunkShift = 18;
constexpr std::uint64_t stepLimit = std::uint64_t{1} << 26U;
constexpr std::uint32_t componentLimit = 1U << 8U;
constexpr std::uint32_t chunkLimit = 1U << 12U;
constexpr std::size_t sequenceLimit = std::size_t{1} << 18U;

std::string_view nameOf(Phase phase) {
    switch (phase) {
    case Phase::resolver:
        return "resolver";
    case Phase::dps:
        return "dps";
    case Phase::interaction:
        return "interaction";
    case Phase::goal:
        return "goal";
    }
    return "";
}

/// With what its texts and lists occupy outside.
std::size_t bytesOf(Event const& event) {
    std::size_t bytes = sizeof(Event) + event.objects.capacity() * sizeof(std::string) +
                        event.causes.capacity() * sizeof(EventId);
    std::size_t const inside = std::string().capacity();
    auto const outside = [&](std::string const& text) {
        return text.capacity() > inside ? text.capacity() + 1 : std::size_t{0};
    };
    bytes += outside(event.component) + outside(event.event);
    for (std::string const& name : event.objects) {
        bytes += outside(name);
    }
    return bytes;
}

[[noreturn]] void throwTooMuch() {
    throw std::length_error(
        fmt::format("an account of at most {} components, {} chunks of 1024 rows and {} frames, "
                    "or parts of frames, can be kept: compute fewer frames, or run without an account",
                    componentLimit, chunkLimit, stepLimit));
}

} // namespace

EventSink::EventSink(Store const* store, Moment when, std::uint32_t component, std::uint32_t chunk,
                     Phase phase, std::string_view name)
    : store_(store), when_(when),
      base_((when.step << stepShift) | (std::uint64_t{component} << componentShift) |
            (std::uint64_t{chunk} << chunkShift)),
      phase_(phase), component_(name) {
    if (component >= componentLimit || chunk >= chunkLimit || when.step >= stepLimit) {
        throwTooMuch();
    }
}

void EventSink::restart(Moment when) {
    if (when.step >= stepLimit) {
        throwTooMuch();
    }
    when_ = when;
    base_ = (when.step << stepShift) | (base_ & ((std::uint64_t{1} << stepShift) - 1));
    events_.clear();
}

EventId EventSink::record(std::string_view event, std::span<ObjectId const> objects,
                          std::span<EventId const> causes) {
    if (events_.size() + 1 >= sequenceLimit) {
        throw std::length_error(
            fmt::format("{} records more than {} events in frame {}; expected at most that many "
                        "in an account: compute fewer frames, or run without an account",
                        component_, sequenceLimit, when_.frame));
    }
    Event made;
    made.id = EventId{base_ + events_.size() + 1};
    made.frame = when_.frame;
    made.part = when_.part;
    made.parts = when_.parts;
    made.phase = phase_;
    made.component = component_;
    made.event = event;
    for (ObjectId const object : objects) {
        made.objects.push_back(store_->nameOf(object));
    }
    for (EventId const cause : causes) {
        if (cause) {
            made.causes.push_back(cause);
        }
    }
    std::sort(made.causes.begin(), made.causes.end());
    made.causes.erase(std::unique(made.causes.begin(), made.causes.end()), made.causes.end());
    events_.push_back(std::move(made));
    return events_.back().id;
}

void Tracer::gather(EventSink& sink) {
    for (Event& event : sink.events()) {
        assert(events_.empty() || events_.back().id < event.id);
        bytes_ += bytesOf(event);
        if (bytes_ > mostBytes_) {
            throw std::length_error(fmt::format(
                "the account of this run takes more than {} MB of memory in frame {}; expected at most that "
                "much: compute fewer frames, or run without an account",
                mostBytes_ / 1'000'000, event.frame));
        }
        events_.push_back(std::move(event));
    }
    sink.events().clear();
}

Event const* Tracer::find(EventId id) const {
    std::uint64_t const n = number(id);
    return n == 0 ? nullptr : &events_[n - 1];
}

std::uint64_t Tracer::number(EventId id) const {
    auto const at = std::lower_bound(events_.begin(), events_.end(), id,
                                     [](Event const& event, EventId wanted) { return event.id < wanted; });
    return at == events_.end() || at->id != id ? 0 : static_cast<std::uint64_t>(at - events_.begin()) + 1;
}

std::vector<EventId> Tracer::chain(EventId id) const {
    std::set<EventId> seen;
    std::vector<EventId> open{id};
    while (!open.empty()) {
        EventId const next = open.back();
        open.pop_back();
        Event const* const event = find(next);
        if (event != nullptr && seen.insert(next).second) {
            open.insert(open.end(), event->causes.begin(), event->causes.end());
        }
    }
    return {seen.begin(), seen.end()};
}

void Tracer::write(std::ostream& out, std::size_t from) const {
    for (std::size_t i = from; i < events_.size(); ++i) {
        Event const& event = events_[i];
        nlohmann::ordered_json causes = nlohmann::ordered_json::array();
        for (EventId const cause : event.causes) {
            if (std::uint64_t const n = number(cause); n != 0) {
                causes.push_back(n);
            }
        }
        nlohmann::ordered_json line{{"id", i + 1}, {"frame", event.frame}};
        if (event.parts > 1) {
            line["part"] = event.part;
        }
        line["phase"] = nameOf(event.phase);
        line["component"] = event.component;
        line["event"] = event.event;
        line["objects"] = event.objects;
        line["causes"] = causes;
        out << escapedJson(line.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
            << '\n';
    }
}

} // namespace trembler
