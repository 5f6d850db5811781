// The causes of long frames are reported: bodies in one place before the first frame, by run and by verify,
// and every slow frame by run.
#include "tests/game/app/program.hpp"
#include "tests/support/boxes.hpp"

namespace trembler::test {
namespace {

class SlowFrames : public InAFolder {
protected:
    /// A level of that many boxes in one place, or side by side.
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
    Ran const verified = runProgram({"verify", level}); // without running for minutes
    EXPECT_EQ(verified.status, 1);
    EXPECT_NE(verified.out.find("44850 pairs"), std::string::npos) << verified.out << verified.err;
    EXPECT_NE(verified.out.find("/objects/"), std::string::npos) << "it names the place: " << verified.out;
}

TEST_F(SlowFrames, AreNotToldOfManyBoxesSideBySide) {
    Ran const ran = runProgram({"run", boxes(300, 0.1), "--frames", "1"});
    EXPECT_NE(ran.status, 2);
    EXPECT_EQ(ran.err.find("pairs"), std::string::npos) << ran.err;
}

// Of a frame that takes longer than stated; none takes no time, and none an hour.
TEST_F(SlowFrames, AreToldOneByOne) {
    std::string const level = boxes(3, 0.1);
    Ran const all = runProgram({"run", level, "--frames", "2", "--slow", "0"});
    for (char const* const told :
         {"trembler: frame 1 took ", "trembler: frame 2 took ", "s of processor time, most of it in "}) {
        EXPECT_NE(all.err.find(told), std::string::npos) << told << ": " << all.err;
    }
    Ran const none = runProgram({"run", level, "--frames", "2", "--slow", "3600"});
    EXPECT_EQ(none.err.find(" took "), std::string::npos) << none.err;
    EXPECT_EQ(none.status, all.status);
    EXPECT_EQ(runProgram({"run", level, "--slow", "nan"}).status, 2);
}

} // namespace
} // namespace trembler::test
