// The identity by which a resolver distinguishes the interactions that call it.
#pragma once

#include <compare>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>

namespace trembler {

/// One caller of a world: an interaction, the level, or a role's feeder outside the world. An interaction's
/// identity belongs to its registration, not to its C++ type, so several interactions of one type are several
/// callers, and it stays the same while interactions are constructed and destroyed.
///
/// Calls do not contain it: a resolver receives it from the channel, with the call (CallOrigin), so no
/// interaction can call with the identity of another. In order: the level, the callers outside, the
/// interactions as registered. Valid while its world lives.
class CallerId {
public:
    /// No caller.
    CallerId() = default;
    /// The level: the caller for all keys that exist before the first call.
    [[nodiscard]] static CallerId level();

    /// The interaction's name, for example "Electricity <- Dynamics", or "level"; empty for no caller.
    [[nodiscard]] std::string_view name() const {
        return known_ == nullptr ? std::string_view() : known_->name;
    }
    [[nodiscard]] explicit operator bool() const { return known_ != nullptr; }
    friend bool operator==(CallerId x, CallerId y) { return x.order() == y.order(); }
    friend std::strong_ordering operator<=>(CallerId x, CallerId y) { return x.order() <=> y.order(); }

private:
    friend class Callers;
    struct Known {
        std::uint32_t order; // its place among the callers; 0: no caller
        std::string name;
    };
    explicit CallerId(Known const& known) : known_(&known) {}
    [[nodiscard]] std::uint32_t order() const { return known_ == nullptr ? 0 : known_->order; }

    Known const* known_ = nullptr; // for its order and name; no result depends on the address
};

/// The callers of one world. Components have no access to it.
class Callers {
public:
    /// An interaction, after all that were added before it.
    CallerId add(std::string_view name) { return make(next_++, name); }
    /// A caller outside the world, before all interactions.
    CallerId addOutside(std::string_view name) { return make(nextOutside_++, name); }

private:
    friend class CallerId;
    static constexpr std::uint32_t levelOrder = 1;
    static constexpr std::uint32_t firstInteraction = 1024;

    CallerId make(std::uint32_t order, std::string_view name) {
        return CallerId(known_.emplace_back(CallerId::Known{order, std::string(name)}));
    }

    std::deque<CallerId::Known> known_; // a deque: pointers to entries must stay valid while more are added
    std::uint32_t nextOutside_ = levelOrder + 1;
    std::uint32_t next_ = firstInteraction;
};

inline CallerId CallerId::level() {
    static Known const known{Callers::levelOrder, "level"};
    return CallerId(known);
}

} // namespace trembler
