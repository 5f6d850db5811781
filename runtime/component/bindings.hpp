// Pointers to exactly the columns and slots that a component declared, and the versions it has seen.
#pragma once

#include "runtime/component/component.hpp"
#include "runtime/component/declarations.hpp"
#include "runtime/world/store.hpp"

#include <algorithm>
#include <array>

namespace trembler::detail {

template <class List>
class Bindings;

template <template <class...> class List, class... P>
class Bindings<List<P...>> {
public:
    void bind(Store& store) {
        homes_ = {&store.home<P>()...};
        [&]<std::size_t... I>(std::index_sequence<I...>) {
            ((watches_[I].version = std::get<I>(homes_)->versionPlace()), ...);
        }
        (std::index_sequence_for<P...>{});
    }

    template <class Q>
    [[nodiscard]] Home<Q>& get() const {
        return *std::get<Home<Q>*>(homes_);
    }
    [[nodiscard]] bool changed() const {
        return std::any_of(watches_.begin(), watches_.end(), [](Watch const& w) { return w.changed(); });
    }
    void markSeen() {
        for (Watch& watch : watches_) {
            watch.seen = *watch.version;
        }
    }
    /// One for each property; they stay where they are.
    [[nodiscard]] std::span<Watch const> watches() const { return watches_; }
    /// The total number of rows of all object properties.
    [[nodiscard]] std::size_t rows() const {
        return (std::size_t{0} + ... + rowsOf(std::get<Home<P>*>(homes_)));
    }

private:
    static std::size_t rowsOf(ColumnBase const* column) { return column->size(); }
    static std::size_t rowsOf(SlotBase const*) { return 0; }

    std::tuple<Home<P>*...> homes_;
    std::array<Watch, sizeof...(P)> watches_{};
};

/// The number of chunks of [0, count); depends only on count and rows.
[[nodiscard]] constexpr std::size_t chunkCount(std::size_t count, std::size_t rows = chunkRows) {
    return count == 0 ? 1 : (count + rows - 1) / rows;
}

template <class F>
void forRanges(Executor& executor, std::size_t count, F&& f, std::size_t rows = chunkRows) {
    std::size_t const chunks = chunkCount(count, rows);
    executor.forIndices(
        chunks, [&](std::size_t chunk) { f(chunk, chunk * rows, std::min(count, (chunk + 1) * rows)); });
}

/// The common part of the three kinds of access.
class AccessBase {
public:
    explicit AccessBase(FrameContext const& context, std::deque<EventSink>& sinks)
        : context_(context), sinks_(sinks) {}

    [[nodiscard]] std::uint64_t frame() const { return context_.when.frame; }
    /// Time since the component's last turn, in s: a part of a frame, a frame, or as many frames as its
    /// period.
    [[nodiscard]] double duration() const { return context_.duration; }
    [[nodiscard]] bool tracing() const { return context_.tracing; }
    /// Records an event; without a trace, does nothing and returns no event. Not inside forRanges().
    EventId event(std::string_view what, std::initializer_list<ObjectId> objects,
                  std::initializer_list<EventId> causes) {
        return event(what, std::span(objects.begin(), objects.size()),
                     std::span(causes.begin(), causes.size()));
    }
    EventId event(std::string_view what, std::span<ObjectId const> objects, std::span<EventId const> causes) {
        return sinks_.empty() ? EventId{} : sinks_.front().record(what, objects, causes);
    }
    /// Calls f(begin, end) for consecutive ranges that cover [0, count), perhaps at the same time. f must
    /// write only data of its range. `rows` > 0 is the length of a range: a constant of the component,
    /// smaller if each row takes long (a range of some microseconds is worth the overhead of a thread).
    template <class F>
    void forRanges(std::size_t count, F&& f, std::size_t rows = chunkRows) {
        detail::forRanges(
            *context_.executor, count,
            [&](std::size_t, std::size_t begin, std::size_t end) { f(begin, end); }, rows);
    }

protected:
    FrameContext const& context_;
    std::deque<EventSink>& sinks_;
};

/// Whether a component states how the state hash covers its data members.
template <class Self>
inline constexpr bool hashesMemory = requires(Self const& self, StateHash& hash) {
    self.hashMemory(hash);
};
template <class Self>
inline constexpr bool statesMemory = requires {
    { Self::memory } -> std::convertible_to<Coverage>;
};
template <class Self, class Base>
void copyMemory(ComponentInfo& info) {
    static_assert(sizeof(Self) == sizeof(Base) || hashesMemory<Self> || statesMemory<Self>,
                  "a component with data members must declare how the state hash covers them: 'void "
                  "hashMemory(StateHash&) const' or 'static constexpr Coverage memory = leftOut(why)'");
    info.hashesMemory = hashesMemory<Self>;
    if constexpr (statesMemory<Self>) {
        info.memory = Self::memory;
    }
}

/// Fills in the properties whose objects activate a component.
template <class... P>
void copyNeeds(NeedsAll<P...> const&, ComponentInfo& info) {
    info.neededAll = {&propertyInfo<P>()...};
}
template <class... P>
void copyNeeds(NeedsAny<P...> const&, ComponentInfo& info) {
    info.neededAny = {&propertyInfo<P>()...};
}

} // namespace trembler::detail
