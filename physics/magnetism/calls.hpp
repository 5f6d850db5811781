// The interaction functions of the Magnetics resolver.
#pragma once

#include "runtime/component/call.hpp"

#include <array>

namespace trembler {

/// The thesis's enableMagnet and disableMagnet in one: the call is held, and a magnet that nobody stands by
/// any more is disabled. So two interactions can never contradict one another.
struct EnableMagnet {
    static constexpr CallText text{
        "enableMagnet", "(object)",
        "Switches the electromagnet on for as long as the call is held; nobody's call "
        "switches it off."};
    static constexpr Algebra algebra = Algebra::anyOf;
    ObjectId object;
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
    [[nodiscard]] std::uint64_t key() const { return packed(object); }
};

struct MagneticsRole {
    static constexpr std::string_view name = "Magnetics";
    using Calls = CallList<EnableMagnet>;
};

} // namespace trembler
