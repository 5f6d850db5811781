// The interaction functions of the Magnetics resolver.
#pragma once

#include "runtime/component/call.hpp"
#include "runtime/property/description.hpp"

#include <array>

namespace trembler {

/// Both calls are held and combined by "or": a magnet is on while any interaction enables it, even if others
/// disable it, so interactions cannot contradict each other. A magnet without any call is off.
struct EnableMagnet {
    static constexpr CallText text{"enableMagnet", "(object)",
                                   "Switches the electromagnet on for as long as the call is held."};
    static constexpr Algebra algebra = Algebra::anyOf;
    ObjectId object;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "the electromagnet", .required = true},
              self.object);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
    [[nodiscard]] std::uint64_t key() const { return packed(object); }
};

/// States the reason why a magnet is off: without the call it would be off as well, but a trace would not
/// contain the reason.
struct DisableMagnet {
    static constexpr CallText text{"disableMagnet", "(object)",
                                   "Switches the electromagnet off unless any interaction enables it."};
    static constexpr Algebra algebra = Algebra::anyOf;
    ObjectId object;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "the electromagnet", .required = true},
              self.object);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
    [[nodiscard]] std::uint64_t key() const { return packed(object); }
};

struct MagneticsRole {
    static constexpr std::string_view name = "Magnetics";
    using Calls = CallList<EnableMagnet, DisableMagnet>;
};

} // namespace trembler
