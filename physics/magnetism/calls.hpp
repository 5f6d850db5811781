// The interaction functions of the Magnetics resolver.
#pragma once

#include "runtime/component/call.hpp"

#include <array>

namespace trembler {

/// Both calls are held, and together they are one "or": a magnet is on while anybody enables it, whoever
/// disables it, so two interactions can never contradict one another. One that nobody mentions is off.
struct EnableMagnet {
    static constexpr CallText text{"enableMagnet", "(object)",
                                   "Switches the electromagnet on for as long as the call is held."};
    static constexpr Algebra algebra = Algebra::anyOf;
    ObjectId object;
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
    [[nodiscard]] std::uint64_t key() const { return packed(object); }
};

/// Says why nobody enables it: without the call the magnet would be off as well, but nobody could tell the
/// reason.
struct DisableMagnet {
    static constexpr CallText text{"disableMagnet", "(object)",
                                   "Leaves the electromagnet off unless anybody enables it."};
    static constexpr Algebra algebra = Algebra::anyOf;
    ObjectId object;
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
    [[nodiscard]] std::uint64_t key() const { return packed(object); }
};

struct MagneticsRole {
    static constexpr std::string_view name = "Magnetics";
    using Calls = CallList<EnableMagnet, DisableMagnet>;
};

} // namespace trembler
