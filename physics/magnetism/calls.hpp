// The interaction functions of the Magnetics resolver.
#pragma once

#include "runtime/component/call.hpp"
#include "runtime/property/description.hpp"

#include <array>

namespace trembler {

/// Both calls are held, and together they are one "or": a magnet is on while any interaction enables it, even
/// if others disable it, so two interactions can never contradict one another. A magnet without any call is
/// off.
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

/// Gives the reason why it is off: without the call the magnet would be off as well, but a trace could not
/// say why.
struct DisableMagnet {
    static constexpr CallText text{"disableMagnet", "(object)",
                                   "Leaves the electromagnet off unless anybody enables it."};
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
