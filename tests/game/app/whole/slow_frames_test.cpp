// The causes of long frames are reported: bodies in one place before the first frame, by run and by verify.
#include "tests/game/app/program.hpp"
#include "tests/support/boxes.hpp"

namespace trembler::test {
namespace {

class SlowFrames : public InAFolder {
protected:
    /// A level of so many boxes in one place, or side by side.
    [[nodiscard]] std::string boxes(int count, double apart) const {
        write(at("boxes.json"), levelOfBoxes(count, apart));
        return at("boxes.json");
    }
};

TEST_F(SlowFrames, OfACrowdAreToldBeforeTheyAreComputed) {
    std::string const level = boxes(300, 0);
    Ran const ran = runProgram({"run", level, "--frames", "1"});
    EXPECT_NE(ran.status, 2) << "it runs all the same";
    EXPECT_NE(ran.err.find("44850 pairs"), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find("box "), std::string::npos) << ran.err;
    Ran const verified = runProgram({"verify", level}); // and is not run for minutes
    EXPECT_EQ(verified.status, 1);
    EXPECT_NE(verified.out.find("44850 pairs"), std::string::npos) << verified.out << verified.err;
    EXPECT_NE(verified.out.find("/objects/"), std::string::npos) << "it names the place: " << verified.out;
}

TEST_F(SlowFrames, AreNotToldOfManyBoxesSideBySide) {
    Ran const ran = runProgram({"run", boxes(300, 0.1), "--frames", "1"});
    EXPECT_NE(ran.status, 2);
    EXPECT_EQ(ran.err.find("pairs"), std::string::npos) << ran.err;
}

} // namespace
} // namespace trembler::test
