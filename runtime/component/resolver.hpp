// Layer 2 (5.4): a resolver is a simulation. Only resolvers change object properties, on advance().
#pragma once

#include "runtime/component/bindings.hpp"
#include "runtime/component/channels.hpp"
#include "runtime/component/component.hpp"
#include "runtime/component/role_info.hpp"
#include "runtime/property/news.hpp"

namespace trembler {

/// Base of every resolver. `Self` has `static constexpr ComponentText text`, `using Activation = ...`, a
/// `void advance(Access&)`, and may have `bool restless() const`: true while it has work although none of its
/// inputs has changed (bodies still move). With `static constexpr bool onDemand = true` it is absent while no
/// constructed component and no subscription (World::want) reads the properties that it provides. When
/// components are constructed or destroyed, it may be advanced without any change of its inputs; its result
/// must then be the same.
template <class Self, ResolverRole RoleType, class ReadsList, class WritesList,
          class ProvidesList = Provides<>>
class Resolver : public Component {
    static_assert(detail::isReads<ReadsList> && detail::isWrites<WritesList> &&
                      detail::isProvides<ProvidesList>,
                  "a resolver must declare Reads<...>, Writes<...>, Provides<...>, in this order (5.4)");
    static_assert(detail::onlyObjectProperties<ReadsList>,
                  "a resolver may read object properties only; data of other simulations reach it through "
                  "interactions (5.4)");
    static_assert(detail::allDeclareNewsOrState<ProvidesList>);

public:
    using Role = RoleType;

    class Access final : public detail::AccessBase {
    public:
        Access(Resolver& self, FrameContext const& context) : AccessBase(context, self.sinks_), self_(self) {}

        template <class P>
        [[nodiscard]] auto const& read() const {
            static_assert(
                detail::listed<P, ReadsList> || detail::listed<P, WritesList>,
                "undeclared read: the property is in neither Reads<> nor Writes<> of this resolver");
            if constexpr (detail::listed<P, WritesList>) {
                return self_.writes_.template get<P>();
            } else {
                return self_.reads_.template get<P>();
            }
        }
        /// The column, for changing. Marks it as changed, so call it only to change something.
        template <class P>
        [[nodiscard]] auto& write() {
            static_assert(detail::listed<P, WritesList>,
                          "undeclared write: the property is not in Writes<> of this resolver");
            auto& column = self_.writes_.template get<P>();
            column.touch();
            return column;
        }
        /// One of its own resolver properties with its current value.
        template <class P>
        [[nodiscard]] P const& provided() const {
            static_assert(detail::listed<P, ProvidesList>,
                          "undeclared: the resolver property is not in Provides<> of this resolver");
            return self_.provides_.template get<P>().value();
        }
        /// One of its own resolver properties, for changing. Marks it as changed.
        template <class P>
        [[nodiscard]] P& provide() {
            static_assert(detail::listed<P, ProvidesList>,
                          "undeclared: the resolver property is not in Provides<> of this resolver");
            auto& slot = self_.provides_.template get<P>();
            slot.touch();
            return slot.value();
        }
        /// Whether any component or subscription reads this resolver property; if not, it need not be
        /// computed.
        template <class P>
        [[nodiscard]] bool wanted() const {
            return self_.provides_.template get<P>().readers() > 0;
        }
        /// Whether a component that the scene needs reads this resolver property. Subscriptions, and
        /// components constructed for subscriptions only, do not count: the world's state may depend on
        /// hasOwnReaders(), but not on wanted().
        template <class P>
        [[nodiscard]] bool hasOwnReaders() const {
            return self_.provides_.template get<P>().ownReaders() > 0;
        }
        /// Calls f(call, origin) for every pending call of kind C, always in the same order. An object in a
        /// held call may have been destroyed: the interaction is applied only after this advance.
        template <InteractionCall C, class F>
        void forCalls(F&& f) const {
            static_assert(detail::callListed<C, typename Role::Calls>,
                          "the call is not in Calls of this resolver's role");
            self_.channel_->template forNotedCalls<C>(std::forward<F>(f));
        }
        /// Whether calls were made or withdrawn since the last advance. If not, the held calls are the same
        /// as then, and there are no others.
        [[nodiscard]] bool callsChanged() const { return self_.channel_->version() != self_.seenCalls_; }
        /// The callers that may call this resolver at present, ascending. An absent interaction is not among
        /// them: its held calls no longer exist, and it can never remove the keys that it added to a counted
        /// set.
        [[nodiscard]] std::span<CallerId const> callers() const { return self_.channel_->callers(); }

    private:
        Resolver& self_;
    };

    Resolver() : Component(describeSelf()) {}

    void bind(Store& store, Channels& channels) final {
        reads_.bind(store);
        writes_.bind(store);
        provides_.bind(store);
        channel_ = &channels.of<Role>();
        channel_->attachResolver();
        if constexpr (requires(Self & self) { self.bindStore(store); }) {
            static_assert(Self::writesEverything, "only a resolver with 'static constexpr bool "
                                                  "writesEverything = true' may take the whole store");
            static_cast<Self&>(*this).bindStore(store);
        }
    }
    [[nodiscard]] bool hasWork() const override {
        if constexpr (requires(Self const& self) { self.restless(); }) {
            if (static_cast<Self const&>(*this).restless()) {
                return true;
            }
        }
        return reads_.changed() || writes_.changed() || channel_->version() != seenCalls_;
    }
    [[nodiscard]] std::size_t workload() const override { return reads_.rows() + writes_.rows(); }
    /// No call is carried out twice, not even if an exception ends the advance: the effects of the call up to
    /// then remain, and the rest of it is never carried out.
    void run(FrameContext const& context) final {
        openSinks(context, Phase::resolver);
        channel_->noteSourcesWithCalls();
        try {
            Access access(*this, context);
            static_cast<Self&>(*this).advance(access);
        } catch (...) {
            channel_->clearOnce();
            throw;
        }
        channel_->clearOnce();
        reads_.markSeen();
        writes_.markSeen();
        seenCalls_ = channel_->version();
    }
    void hashState(StateHash& hash) const final {
        if (channel_ != nullptr) {
            channel_->hash(hash);
        }
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
        ComponentInfo made{.type = typeid(Self), .kind = ComponentKind::resolver, .text = text};
        made.reads = detail::infos(ReadsList{});
        made.writes = detail::infos(WritesList{});
        made.offers = detail::infos(ProvidesList{});
        made.role = typeid(Role);
        made.roleName = Role::name;
        made.roleInfo = &roleInfo<Role>();
        [&]<class... C>(CallList<C...> const&) {
            made.calls = {CallInfo{C::text, C::algebra}...};
        }(typename Role::Calls{});
        detail::copyMemory<Self, Resolver>(made);
        detail::copyNeeds(typename Self::Activation{}, made);
        if constexpr (requires { Self::onDemand; }) {
            made.onDemand = Self::onDemand;
        }
        if constexpr (requires { Self::writesEverything; }) {
            made.writesEverything = Self::writesEverything;
        }
        return made;
    }

protected:
    /// For a type that is registered several times, see Registry::component.
    explicit Resolver(ComponentInfo const& info) : Component(info) {}
    /// Whether there is any held call, or any call that waits to be executed.
    [[nodiscard]] bool isCalled() const { return channel_ != nullptr && !channel_->empty(); }

private:
    detail::Bindings<ReadsList> reads_;
    detail::Bindings<WritesList> writes_;
    detail::Bindings<ProvidesList> provides_;
    Channel<Role>* channel_ = nullptr;
    std::uint64_t seenCalls_ = 0;
};

} // namespace trembler
