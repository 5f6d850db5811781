#include "measure/accuracy/ladders/ngspice.hpp"

#include <gtest/gtest.h>

namespace trembler::accuracy {
namespace {

// The results of ngspice and of elimination for the same circuits; they share no code.
TEST(Ngspice, NgspiceAndEliminationAgree) {
    // A netlist written by hand: one lamp of 12 ohm on a source of 12 V with 0.1 ohm, and halves of wires.
    std::string const netlist = "* one\n* 0 = 'minus'\n* n1 = 'plus', 'wire'\n* n2 = 'lamp'\n"
                                "v1 p1 0 dc 12\nr1 p1 n1 0.1\nr2 n1 n2 6\nr3 n2 0 6\n"
                                ".control\nset numdgt=15\nop\nprint all\n.endc\n.end\n";
    auto const found = potentialsByNgspice(netlist);
    EXPECT_FALSE(potentialsByNgspice("").has_value());
    if (!found) {
        GTEST_SKIP() << "ngspice is not installed";
    }
    EXPECT_EQ(found->size(), 4U);
    EXPECT_EQ(found->at("minus"), 0);
    EXPECT_NEAR(found->at("plus"), 12 * 12 / 12.1, 1e-9);
    EXPECT_NEAR(found->at("wire"), 12 * 12 / 12.1, 1e-9);
    EXPECT_NEAR(found->at("lamp"), 12 * 6 / 12.1, 1e-9);
}

} // namespace
} // namespace trembler::accuracy
