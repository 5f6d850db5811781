// The volts, amperes and ohms of objects: the properties that need nodal analysis.
#pragma once

#include "runtime/property/description.hpp"

namespace trembler {

/// The least resistance above zero, and the greatest, in ohm. An object with 0 conducts ideally. The solver
/// is tested over the twelve orders of magnitude between them.
inline constexpr double leastResistance = 1e-3;
inline constexpr double greatestResistance = 1e9;

/// Between any two of its connections an object has the whole resistance: half of it lies between the
/// object's middle and each connection. So a bar with three connections is a star of three halves.
struct Resistance {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Resistance", "resistance",
                                       "The electrical resistance from one side of the object to the other."};
    double ohm = 0;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value",
                        .unit = "ohm",
                        .meaning = "0 (an ideal conductor) or at least 0.001",
                        .minimum = 0,
                        .maximum = greatestResistance,
                        .required = true},
              self.ohm);
    }
    friend bool operator==(Resistance const&, Resistance const&) = default;
};

/// How a source drives current from the return node of its network, which is at 0 V, to the object.
struct Emf {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Electromotive force", "emf",
                                       "The voltage with which an electrical source drives a current."};
    double voltage = 0;
    double internalResistance = 0;
    double induced = 0; ///< V, the sum of all AddVoltage calls at present

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "voltage",
                        .unit = "V",
                        .meaning = "of the object relative to the return of its network, without a load",
                        .minimum = -1e6,
                        .maximum = 1e6,
                        .required = true},
              self.voltage);
        visit(FieldInfo{.key = "internal_resistance",
                        .unit = "ohm",
                        .meaning = "in series with the source; 0 (an ideal source) or at least 0.001",
                        .minimum = 0,
                        .maximum = greatestResistance},
              self.internalResistance);
        visit(FieldInfo{.key = "induced",
                        .unit = "V",
                        .meaning = "what interactions add to it at present",
                        .minimum = -1e6,
                        .maximum = 1e6},
              self.induced);
    }
    friend bool operator==(Emf const&, Emf const&) = default;
};

/// The rating of a lamp: 6 V, 3 W. Without a stated resistance the rating determines it: V²/P.
struct RatedPower {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Rated power", "rated",
                                       "The power and the voltage for which the object is designed."};
    double power = 1;
    double voltage = 1;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "power",
                        .unit = "W",
                        .meaning = "power at full brightness",
                        .minimum = 0,
                        .maximum = 1e9,
                        .minimumExcluded = true,
                        .required = true},
              self.power);
        visit(FieldInfo{.key = "voltage",
                        .unit = "V",
                        .meaning = "across the object at that power",
                        .minimum = 0,
                        .maximum = 1e6,
                        .minimumExcluded = true,
                        .required = true},
              self.voltage);
    }
    friend bool operator==(RatedPower const&, RatedPower const&) = default;
};

/// Carries a current up to its rating. Above the rating it blows and no longer conducts.
struct Fuse {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "Fuse", "fuse", "Blows, and then conducts no more, when its current exceeds its rating."};
    double current = 1;
    bool blown = false;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "current",
                        .unit = "A",
                        .meaning = "greatest current that it carries without blowing",
                        .minimum = 0,
                        .maximum = 1e9,
                        .minimumExcluded = true,
                        .required = true},
              self.current);
        visit(FieldInfo{.key = "blown", .unit = "", .meaning = "whether it has blown, which is permanent"},
              self.blown);
    }
    friend bool operator==(Fuse const&, Fuse const&) = default;
};

/// The greatest current that an object can carry, for the detail level flow.
struct CurrentCapacity {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "Current capacity", "current_capacity",
        "The greatest current that the object can carry, at the detail level \"flow\"."};
    double ampere = 1;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value",
                        .unit = "A",
                        .meaning = "rounded to whole microamperes",
                        .minimum = 0,
                        .maximum = 1e6,
                        .required = true},
              self.ampere);
    }
    friend bool operator==(CurrentCapacity const&, CurrentCapacity const&) = default;
};

} // namespace trembler
