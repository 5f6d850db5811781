#include "physics/dynamics/rules/joint_rules.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace trembler {
namespace {

using Fault = std::optional<std::string>;

// The ranges of files, also for joints that are not from files.
Fault faultInNumbers(Joint const& joint) {
    struct Range {
        std::string_view what;
        double value;
        double minimum;
        double maximum;
    };
    constexpr double far = 1e6;
    std::array<Range, 19> const ranges{{{"place", joint.at.x, -far, far},
                                        {"place", joint.at.y, -far, far},
                                        {"place at b", joint.atB.x, -far, far},
                                        {"place at b", joint.atB.y, -far, far},
                                        {"axis", joint.axis.x, -far, far},
                                        {"axis", joint.axis.y, -far, far},
                                        {"pulley over a", joint.groundA.x, -far, far},
                                        {"pulley over a", joint.groundA.y, -far, far},
                                        {"pulley over b", joint.groundB.x, -far, far},
                                        {"pulley over b", joint.groundB.y, -far, far},
                                        {"lower limit", joint.lower, -far, far},
                                        {"upper limit", joint.upper, -far, far},
                                        {"motor speed", joint.motorSpeed, -far, far},
                                        {"motor strength", joint.motorStrength, 0, 1e9},
                                        {"length", joint.length, 0, far},
                                        {"stiffness", joint.stiffness, 0, 1e9},
                                        {"damping rate", joint.dampingRate, 0, 1e9},
                                        {"ratio", joint.ratio, -1e3, 1e3},
                                        {"breaking force", joint.breakForce, 0, 1e12}}};
    for (Range const& range : ranges) {
        if (!(range.value >= range.minimum && range.value <= range.maximum)) {
            return fmt::format("its {} is {}; expected {} to {}", range.what, range.value, range.minimum,
                               range.maximum);
        }
    }
    return std::nullopt;
}

Fault faultInGear(Joint const& joint, JointPartners const& partners) {
    auto const turnsOrSlides = [](Joint const* other) {
        return other != nullptr && (other->form == JointForm::hinge || other->form == JointForm::slider);
    };
    if (!turnsOrSlides(partners.jointA) || !turnsOrSlides(partners.jointB)) {
        return "a gear couples two joints; expected joint_a and joint_b to name a hinge or a slider each";
    }
    if (joint.jointA == joint.jointB || partners.jointA->a == partners.jointB->a) {
        return "a gear couples the motion of two objects; expected the joints that it names to have "
               "different "
               "objects a";
    }
    if (partners.jointA->a != joint.a || (joint.b.valid() && partners.jointB->a != joint.b)) {
        return "a gear's a and b must be the objects a of the joints that joint_a and joint_b name";
    }
    return std::nullopt;
}

} // namespace

Fault faultIn(Joint const& joint, JointPartners const& partners) {
    if (!partners.aIsBody) {
        return "its object a has no valid shape or no place; expected an object that can move";
    }
    if (joint.b.valid() && joint.b == joint.a) {
        return "it ties an object to itself; expected two different objects, or no b for the world";
    }
    if (joint.b.valid() && !partners.bIsBody) {
        return "its object b has no valid shape or no place; expected an object with both, or no b for the "
               "world";
    }
    if (partners.aFixed && (!joint.b.valid() || partners.bFixed) && joint.form != JointForm::gear) {
        return "it connects fixed objects only; expected at least one movable object";
    }
    if (Fault fault = faultInNumbers(joint)) {
        return fault;
    }
    // Checked also while limits are off, as they may be switched on later.
    if (joint.lower > joint.upper) {
        return fmt::format("its lower limit, {}, is above its upper one, {}", joint.lower, joint.upper);
    }
    switch (joint.form) {
    case JointForm::slider:
    case JointForm::wheel:
        if (!(length(joint.axis) > 1e-6)) {
            return "its axis has no direction; expected, for example, [1, 0]";
        }
        if (joint.form == JointForm::slider || joint.stiffness > 0) {
            return std::nullopt;
        }
        return "a wheel is held by a spring; expected a stiffness above 0 N/m";
    case JointForm::spring:
        return joint.stiffness > 0 ? std::nullopt : Fault("a spring needs a stiffness above 0 N/m");
    case JointForm::pulley:
        if (!joint.b.valid()) {
            return "a pulley's rope has two ends; expected an object b";
        }
        if (!(joint.ratio > 1e-3)) {
            return fmt::format("its ratio is {}; expected more than 0.001 for a pulley", joint.ratio);
        }
        if (length(joint.at - joint.groundA) < 1e-3 || length(joint.atB - joint.groundB) < 1e-3) {
            return "an end of its rope lies on the pulley that it runs over; expected at least 0.001 m "
                   "between";
        }
        return std::nullopt;
    case JointForm::gear:
        if (std::abs(joint.ratio) < 1e-3) {
            return fmt::format("its ratio is {}; expected at least 0.001 or at most -0.001 for a gear",
                               joint.ratio);
        }
        return faultInGear(joint, partners);
    case JointForm::distance:
        if (!(joint.length > 0) && length(joint.at - joint.atB) < 1e-3) {
            return "its ends coincide; expected a length of at least 0.001 m (or a hinge instead)";
        }
        return std::nullopt;
    case JointForm::rope:
        if (!(joint.length > 0) && length(joint.at - joint.atB) < 1e-3) {
            return "its ends coincide and it has no length; expected a length of at least 0.001 m";
        }
        return std::nullopt;
    case JointForm::hinge:
    case JointForm::weld:
        return std::nullopt;
    }
    return "it has an unknown form";
}

} // namespace trembler
