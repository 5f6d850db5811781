#include "puzzle/run/slow_frame.hpp"
#include "tests/support/experiment.hpp"

namespace trembler {
namespace slow_frame_test {
namespace {

class SlowFrames : public Experiment {};

TEST_F(SlowFrames, AreThoseAboveTheLimit) {
    open("1-switched-electromagnet.json");
    double now = 100;
    FrameTimer timer(2, [&] { return now; });
    timer.begin();
    session().step();
    now += 2;
    EXPECT_FALSE(timer.end(session().world()));
    timer.begin();
    session().step();
    now += 2.5;
    auto const slow = timer.end(session().world());
    ASSERT_TRUE(slow);
    EXPECT_EQ(slow->frame, 2U);
    EXPECT_EQ(slow->seconds, 2.5);
    auto const status = session().world().status();
    EXPECT_TRUE(std::any_of(status.begin(), status.end(), [&](auto const& component) {
        return component.info->text.name == slow->component;
    })) << slow->component;
}

TEST_F(SlowFrames, AreToldWithTheirNumberTheirTimeAndTheirComponent) {
    EXPECT_EQ(inWords({12, 3.14, "Dynamics"}),
              "frame 12 took 3.1 s of processor time, most of it in Dynamics");
    EXPECT_EQ(inWords({1, 2, ""}), "frame 1 took 2.0 s of processor time, most of it in no component");
}

TEST_F(SlowFrames, AreMeasuredInTimeThatThisProcessUses) {
    double const before = processorSeconds();
    double sum = 0;
    while (processorSeconds() == before) { // ends, however busy the machine is
        sum += 1;
    }
    EXPECT_GT(processorSeconds(), before);
    EXPECT_GE(sum, 0);
}

} // namespace
} // namespace slow_frame_test
} // namespace trembler
