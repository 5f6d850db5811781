// Layer 3 (5.5): a derived property set is a pure function of properties. It changes nothing but its results.
#pragma once

#include "runtime/component/bindings.hpp"
#include "runtime/component/channels.hpp"
#include "runtime/component/component.hpp"
#include "runtime/property/news.hpp"

namespace trembler {

/// Base of every derived property set. `Self` has `static constexpr ComponentText text`, `using Activation =
/// ...` and a `void update(Access&)`. It runs only when a property that it reads has changed. With `static
/// constexpr bool onDemand = true` it is absent while no constructed component and no subscription
/// (World::want) reads the properties that it derives.
template <class Self, class ReadsList, class DerivesList>
class Dps : public Component {
    static_assert(detail::isReads<ReadsList> && detail::isDerives<DerivesList>,
                  "a derived property set must declare Reads<...>, Derives<...>, in this order, and may "
                  "write nothing else (5.5)");
    static_assert(!detail::anyDerived<ReadsList>,
                  "a derived property set may not read derived properties (5.5)");
    // Properties derived from states are states. Properties derived from news may hold for one part only.
    static_assert(detail::allDeclareNewsOrState<
                  std::conditional_t<detail::anyReportsNews<ReadsList>, DerivesList, Derives<>>>);

public:
    class Access final : public detail::AccessBase {
    public:
        Access(Dps& self, FrameContext const& context) : AccessBase(context, self.sinks_), self_(self) {}

        /// A column, or the value of a resolver property.
        template <class P>
        [[nodiscard]] auto const& read() const {
            static_assert(detail::listed<P, ReadsList>,
                          "undeclared read: the property is not in Reads<> of this derived property set");
            if constexpr (ObjectProperty<P>) {
                return static_cast<Column<P> const&>(self_.reads_.template get<P>());
            } else {
                return static_cast<Slot<P> const&>(self_.reads_.template get<P>()).value();
            }
        }
        template <class P>
        void write() {
            static_assert(
                sizeof(P) == 0,
                "a derived property set may not write a property; write its results with derive() (5.5)");
        }
        /// One of its derived properties, for writing. It still has the value of the last update, which an
        /// alternative of this component may have computed.
        template <class P>
        [[nodiscard]] P& derive() {
            static_assert(
                detail::listed<P, DerivesList>,
                "undeclared: the derived property is not in Derives<> of this derived property set");
            auto& slot = self_.derives_.template get<P>();
            slot.touch();
            return slot.value();
        }

        /// One of its derived properties with its current value, without marking it as changed, to find out
        /// whether it needs to change.
        template <class P>
        [[nodiscard]] P const& derived() const {
            static_assert(
                detail::listed<P, DerivesList>,
                "undeclared: the derived property is not in Derives<> of this derived property set");
            return self_.derives_.template get<P>().value();
        }

    private:
        Dps& self_;
    };

    Dps() : Component(describeSelf()) {}

    void bind(Store& store, Channels&) final {
        reads_.bind(store);
        derives_.bind(store);
    }
    [[nodiscard]] bool hasWork() const final { return first_ || reads_.changed(); }
    [[nodiscard]] std::size_t workload() const override { return reads_.rows(); }
    void run(FrameContext const& context) final {
        openSinks(context, Phase::dps);
        Access access(*this, context);
        static_cast<Self&>(*this).update(access);
        reads_.markSeen();
        first_ = false;
        this->waitFor(reads_.watches());
    }
    void hashState([[maybe_unused]] StateHash& hash) const final {
        if constexpr (detail::hashesMemory<Self>) {
            static_cast<Self const&>(*this).hashMemory(hash);
        }
    }
    [[nodiscard]] static ComponentInfo const& describeSelf() {
        static ComponentInfo const info = [] {
            ComponentInfo made{.type = typeid(Self), .kind = ComponentKind::dps, .text = Self::text};
            made.reads = detail::infos(ReadsList{});
            made.offers = detail::infos(DerivesList{});
            detail::copyMemory<Self, Dps>(made);
            detail::copyNeeds(typename Self::Activation{}, made);
            if constexpr (requires { Self::onDemand; }) {
                made.onDemand = Self::onDemand;
            }
            return made;
        }();
        return info;
    }

private:
    bool first_ = true; // not last: members of Self must not use the padding after it, see copyMemory()
    detail::Bindings<ReadsList> reads_;
    detail::Bindings<DerivesList> derives_;
};

} // namespace trembler
