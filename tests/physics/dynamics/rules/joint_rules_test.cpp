// Invalid joints are refused with the reason.
#include "physics/dynamics/rules/joint_rules.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace trembler {
namespace joint_rules_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(JointRules, ReportErrors) {
    ObjectId const a{1, 0};
    ObjectId const b{2, 0};
    JointPartners const sound{.aIsBody = true, .bIsBody = true};
    auto const fault = [&](JointPartners const& partners, auto&& change) {
        Joint joint;
        joint.a = a;
        joint.b = b;
        joint.atB = {1, 0};
        change(joint);
        return faultIn(joint, partners).value_or("");
    };
    auto const same = [](Joint&) {};
    EXPECT_EQ(fault(sound, same), "");
    EXPECT_NE(fault({.aIsBody = false, .bIsBody = true}, same).find("object a has no"), std::string::npos);
    EXPECT_NE(fault({.aIsBody = true, .bIsBody = false}, same).find("object b has no"), std::string::npos);
    EXPECT_NE(fault(sound, [&](Joint& j) { j.b = a; }).find("to itself"), std::string::npos);
    EXPECT_NE(fault({.aIsBody = true, .bIsBody = true, .aFixed = true, .bFixed = true}, same).find("fixed"),
              std::string::npos);
    EXPECT_NE(fault(sound, [](Joint& j) { j.at = {nan, 0}; }).find("place is nan"), std::string::npos);
    EXPECT_NE(fault(sound, [](Joint& j) { j.limited = true, j.lower = 1; }).find("above its upper"),
              std::string::npos);
    EXPECT_NE(
        fault(sound, [](Joint& j) { j.form = JointForm::slider, j.upper = -1; }).find("above its upper"),
        std::string::npos); // also while the limits are disabled
    auto const form = [&](JointForm wanted, auto&& change) {
        return fault(sound, [&](Joint& j) {
            j.form = wanted;
            change(j);
        });
    };
    EXPECT_NE(form(JointForm::slider, [](Joint& j) { j.axis = {}; }).find("no direction"), std::string::npos);
    EXPECT_NE(form(JointForm::spring, same).find("stiffness"), std::string::npos);
    EXPECT_NE(form(JointForm::wheel, same).find("stiffness"), std::string::npos);
    EXPECT_NE(form(JointForm::distance, [](Joint& j) { j.atB = j.at; }).find("coincide"), std::string::npos);
    EXPECT_NE(form(JointForm::pulley, [](Joint& j) { j.b = {}; }).find("two ends"), std::string::npos);
    EXPECT_NE(form(JointForm::pulley, [](Joint& j) { j.ratio = 0; }).find("ratio is 0"), std::string::npos);
    EXPECT_NE(form(JointForm::gear, same).find("couples two joints"), std::string::npos);
}

} // namespace
} // namespace joint_rules_test
} // namespace trembler
