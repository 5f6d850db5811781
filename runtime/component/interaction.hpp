// Layer 4 (5.6): an interaction connects effects. It reads from all layers and calls functions of exactly one
// resolver.
#pragma once

#include "runtime/component/bindings.hpp"
#include "runtime/component/call_trace.hpp"
#include "runtime/component/channels.hpp"
#include "runtime/component/component.hpp"

namespace trembler {

/// Base of every interaction. `Self` has `static constexpr ComponentText text`, `using Activation = ...` and
/// a `void apply(Access&)`.
///
/// It is applied whenever a property that it reads has changed. Otherwise its held calls stay in effect, so
/// applying it again would change nothing. `Self` may have `bool restless() const`: while true, it is applied
/// all the same. With `static constexpr bool inSetup = true` it is also applied in
/// frame 0, the setup before the first advance (6.8.3: "global properties, such as the gravity vector, will
/// also be set"); it then reads object properties only.
template <class Self, ResolverRole RoleType, class ReadsList>
class Interaction : public Component {
    static_assert(detail::isReads<ReadsList>,
                  "an interaction must declare Reads<...>, and may not declare Writes<...> (5.6)");

public:
    using Role = RoleType;
    using Buffers = typename CallSource<Role>::Buffers;

    /// Records the calls of one chunk. Used by one thread at a time.
    class Caller {
    public:
        /// Records a call. `cause` is the event that leads to it, none without a trace. O(1), no locks.
        template <class C>
        void call(C const& c, EventId cause = {}) {
            static_assert(detail::callListed<C, typename Role::Calls>,
                          "an interaction may call functions of the one role that it declares only (5.6)");
            static_assert(C::algebra != Algebra::sequence,
                          "an interaction may not make a call with Algebra::sequence: such calls come from "
                          "outside the world only");
            std::get<CallBuffer<C>>(buffers_).push(c);
            if (sink_ != nullptr) [[unlikely]] {
                traceLast<C>(cause);
            }
        }

    private:
        friend class Interaction;
        Caller(Interaction& self, std::size_t chunk)
            : self_(self), buffers_(self.source_.chunks[chunk]),
              sink_(self.sinks_.empty() ? nullptr : &self.sinks_[chunk]), chunk_(chunk) {}

        // Out of line, and from the recorded call: if the trace used the argument of call(), the compiler
        // would write that to the stack member by member and read it back in larger pieces, a
        // store-forwarding stall that made an untraced call take twice as long.
        template <class C>
        [[gnu::noinline, gnu::cold]] void traceLast(EventId cause) {
            auto& buffer = std::get<CallBuffer<C>>(buffers_);
            buffer.setCauseOfLast(self_.trace_.record(buffer.calls().back(), cause, *sink_, chunk_));
        }

        Interaction& self_;
        Buffers& buffers_;
        EventSink* sink_;
        std::size_t chunk_;
    };

    class Access final : public detail::AccessBase {
    public:
        Access(Interaction& self, FrameContext const& context)
            : AccessBase(context, self.sinks_), self_(self), first_(self, 0) {}

        /// A column, or the value of a resolver or derived property.
        template <class P>
        [[nodiscard]] auto const& read() const {
            static_assert(detail::listed<P, ReadsList>,
                          "undeclared read: the property is not in Reads<> of this interaction");
            if constexpr (ObjectProperty<P>) {
                return static_cast<Column<P> const&>(self_.reads_.template get<P>());
            } else {
                return static_cast<Slot<P> const&>(self_.reads_.template get<P>()).value();
            }
        }
        template <class P>
        void write() {
            static_assert(sizeof(P) == 0,
                          "an interaction may not write a property: call the resolver that writes it (5.6)");
        }
        /// True in the first turn after the component was constructed: it must then process all objects, not
        /// only changes since the last frame.
        [[nodiscard]] bool firstTime() const { return self_.first_; }
        /// Its identity as a caller, by which the resolver counts its additions to a counted set.
        [[nodiscard]] CallerId caller() const { return self_.source_.caller; }
        /// Records a call; see Caller::call.
        template <class C>
        void call(C const& c, EventId cause = {}) {
            first_.call(c, cause);
        }
        /// Calls f(caller, begin, end) for consecutive ranges that cover [0, count), perhaps at the same
        /// time.
        template <class F>
        void forChunks(std::size_t count, F&& f) {
            std::size_t const chunks = detail::chunkCount(count);
            self_.prepareChunks(chunks, context_);
            detail::forRanges(*context_.executor, count,
                              [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                                  Caller caller(self_, chunk);
                                  f(caller, begin, end);
                              });
        }

    private:
        Interaction& self_;
        Caller first_;
    };

    Interaction() : Component(describeSelf()) {}

    void bind(Store& store, Channels& channels) final {
        reads_.bind(store);
        source_.caller = this->caller();
        channels.of<Role>().add(&source_);
    }
    [[nodiscard]] bool hasWork() const final {
        if constexpr (requires(Self const& self) { self.restless(); }) {
            if (static_cast<Self const&>(*this).restless()) {
                return true;
            }
        }
        return first_ || reads_.changed();
    }
    [[nodiscard]] std::size_t workload() const override { return reads_.rows(); }
    /// A turn that ends by an exception has made no calls: its records are withdrawn, as the next turn makes
    /// all its calls again. Nothing is held until then.
    void run(FrameContext const& context) final {
        bool const stood = !source_.empty();
        source_.startTurn();
        trace_.begin();
        try {
            openSinks(context, Phase::interaction);
            Access access(*this, context);
            static_cast<Self&>(*this).apply(access);
        } catch (...) {
            source_.withdrawTurn();
            trace_.forget();
            sinks_.clear();
            source_.version += stood ? 1 : 0;
            throw;
        }
        trace_.end();
        if (stood || !source_.empty()) { // otherwise the resolver's calls have not changed
            ++source_.version;
        }
        reads_.markSeen();
        first_ = false;
        if constexpr (!requires(Self const& self) { self.restless(); }) {
            this->waitFor(reads_.watches());
        }
    }
    void hashState([[maybe_unused]] StateHash& hash) const final {
        if constexpr (detail::hashesMemory<Self>) {
            static_cast<Self const&>(*this).hashMemory(hash);
        }
    }
    /// Its description. A type that is registered several times has no `text` of its own, see describeAs().
    [[nodiscard]] static ComponentInfo const& describeSelf() {
        static ComponentInfo const info = describeAs(Self::text);
        return info;
    }
    /// Its description with the name, level and rank of one of its registrations, see Registry::component.
    [[nodiscard]] static ComponentInfo describeAs(ComponentText const& text) {
        ComponentInfo made{.type = typeid(Self), .kind = ComponentKind::interaction, .text = text};
        made.reads = detail::infos(ReadsList{});
        made.role = typeid(Role);
        made.roleName = Role::name;
        detail::copyMemory<Self, Interaction>(made);
        detail::copyNeeds(typename Self::Activation{}, made);
        if constexpr (requires { Self::inSetup; }) {
            static_assert(detail::onlyObjectProperties<ReadsList>,
                          "an interaction that runs in the setup may read object properties only: no "
                          "resolver has advanced, and no derived property set has been updated");
            made.inSetup = Self::inSetup;
        }
        return made;
    }

protected:
    /// For a type that is registered several times, see Registry::component.
    explicit Interaction(ComponentInfo const& info) : Component(info) {}

private:
    void prepareChunks(std::size_t chunks, FrameContext const& context) {
        if (source_.chunks.size() < chunks) {
            source_.chunks.resize(chunks);
        }
        trace_.widen(chunks);
        if (sinks_.size() < chunks && context.tracing) {
            for (std::size_t chunk = sinks_.size(); chunk < chunks; ++chunk) {
                sinks_.emplace_back(context.store, context.when, context.component,
                                    static_cast<std::uint32_t>(chunk), Phase::interaction, info_.text.name);
            }
        }
    }

    bool first_ = true; // not last: members of Self must not use the padding after it, see copyMemory()
    detail::Bindings<ReadsList> reads_;
    CallSource<Role> source_;
    CallTrace trace_;
};

} // namespace trembler
