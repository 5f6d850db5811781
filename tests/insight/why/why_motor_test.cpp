// Experiment III, an electric motor, and its variants: the answer's chain is that of the thesis's account
// (6.10.3), which the experiment's recorded solutions change or end.
#include "tests/insight/support/told_experiment.hpp"

#include <gtest/gtest.h>

namespace trembler::insight {
namespace why_motor {
namespace {

std::size_t timesOf(Answer const& answer, StepKind kind, std::vector<std::string> const& objects) {
    std::size_t const place = placeIn(answer, kind, objects);
    return place < answer.chain.size() ? answer.chain[place].times : 0;
}

// "It will come into contact with the top spoke"; "it will further push any 'north spokes' away from it, in
// particular the one closest to it"; "the 'south spoke' below ... there will be a large attracting force";
// "until the next spoke (this time a 'south' spoke) collides with the sliding contact, activating the other
// electromagnet".
TEST(WhyMotor, TheAccountOfTheStartIsTheChainTold) {
    Answer const answer =
        answerIn("3-electric-motor", "hands off", ofObject("lower electromagnet", 1.08), 120);
    ASSERT_TRUE(answer.happened);
    expectChain(answer, {{StepKind::contact, {"sliding contact", "spoke 1"}},
                         {StepKind::on, {"upper electromagnet"}},
                         {StepKind::magnetOn, {"upper electromagnet"}},
                         {StepKind::push, {"spoke 4", "upper electromagnet"}},
                         {StepKind::pull, {"spoke 7", "upper electromagnet"}},
                         {StepKind::contact, {"sliding contact", "spoke 8"}},
                         {StepKind::on, {"lower electromagnet"}},
                         {StepKind::magnetOn, {"lower electromagnet"}}});
    EXPECT_LT(answer.chain[placeIn(answer, StepKind::contact, {"spoke 1"})].step.frame, 30U);
    EXPECT_GE(answer.chain[placeIn(answer, StepKind::contact, {"spoke 8"})].step.frame, 60U);
    EXPECT_LT(answer.chain[placeIn(answer, StepKind::contact, {"spoke 8"})].step.frame, 90U);
    EXPECT_EQ(answer.chain.size(), 8U) << told(answer);
    EXPECT_EQ(told(answer),
              "The lower electromagnet becomes magnetic, because current flows through the lower "
              "electromagnet, because the sliding contact touches spoke 8, because the upper electromagnet "
              "pushes spoke 4 away and because the upper electromagnet pulls spoke 7, because the upper "
              "electromagnet becomes magnetic. The upper electromagnet becomes magnetic, because current "
              "flows through the upper electromagnet, because the sliding contact touches spoke 1. ");
}

// "This basic process will repeat for a while": the electromagnets take turns, spoke after spoke, and what is
// told of one turn is told of all.
TEST(WhyMotor, TheProcessRepeats) {
    Answer const answer =
        answerIn("3-electric-motor", "hands off", ofObject("lower electromagnet", 5.2), 320);
    ASSERT_TRUE(answer.happened);
    expectChain(answer, {{StepKind::on, {"upper electromagnet"}},
                         {StepKind::magnetOn, {"upper electromagnet"}},
                         {StepKind::push, {"upper electromagnet"}},
                         {StepKind::pull, {"upper electromagnet"}},
                         {StepKind::on, {"lower electromagnet"}},
                         {StepKind::magnetOn, {"lower electromagnet"}},
                         {StepKind::pull, {"lower electromagnet"}},
                         {StepKind::push, {"lower electromagnet"}},
                         {StepKind::contact, {"sliding contact", "spoke 6"}}});
    for (char const* const coil : {"upper electromagnet", "lower electromagnet"}) {
        for (StepKind const kind : {StepKind::on, StepKind::magnetOn, StepKind::push, StepKind::pull}) {
            EXPECT_GE(timesOf(answer, kind, {coil}), 3U) << coil << ": " << told(answer);
        }
    }
    EXPECT_LT(answer.chain.size(), 25U) << told(answer);
}

// Without the other electromagnet it turns as soon, so that only one of them is named.
TEST(WhyMotor, ItTurnsBecauseOfItsElectromagnet) {
    for (std::string const solution : {"hands off", "lift the sliding contact"}) {
        Answer const answer = answerIn("3-electric-motor", solution);
        ASSERT_TRUE(answer.happened);
        expectChain(answer, {{StepKind::contact, {"sliding contact"}},
                             {StepKind::on, {"upper electromagnet"}},
                             {StepKind::magnetOn, {"upper electromagnet"}},
                             {StepKind::push, {"upper electromagnet"}},
                             {StepKind::pull, {"upper electromagnet"}},
                             {StepKind::goal, {"spoke 1"}}});
        EXPECT_TRUE(answer.confirmed) << told(answer);
        EXPECT_GE(timesOf(answer, StepKind::contact, {"sliding contact"}), 3U) << told(answer);
        EXPECT_EQ(placeIn(answer, StepKind::magnetOff, {}), answer.chain.size()) << told(answer);
        EXPECT_NE(told(answer).find("(and so on, "), std::string::npos) << told(answer);
    }
}

// Recorded alternatives end the current: "should the main electrical circuit be broken".
TEST(WhyMotor, ItIsWithoutCurrentBecauseOfWhatThePlayerDid) {
    std::pair<std::string, StepKind> const alternatives[]{{"lift the sliding contact", StepKind::grabbed},
                                                          {"cut the wire", StepKind::cut}};
    for (auto const& [solution, deed] : alternatives) {
        Answer const answer = answerIn("3-electric-motor", solution, {}, 0, true);
        ASSERT_TRUE(answer.happened) << solution;
        expectChain(answer, {{deed, {"sliding contact"}},
                             {StepKind::goal, {"upper electromagnet", "lower electromagnet"}}});
        expectChain(answer, {{StepKind::contact, {"sliding contact"}},
                             {StepKind::off, {"lower electromagnet"}},
                             {StepKind::goal, {"upper electromagnet", "lower electromagnet"}}});
    }
}

// Experiment III: "the sliding contact falls onto a spoke and closes a circuit through it", and opens it.
TEST(WhyMotor, TheMotorsMagnetIsSwitchedByTheSlidingContact) {
    Answer const off = answerIn("3-electric-motor", "hands off", ofObject("upper electromagnet", 1), 120);
    ASSERT_TRUE(off.happened);
    expectInOrder(off, {{StepKind::contact, {"sliding contact", "spoke 1"}},
                        {StepKind::off, {"upper electromagnet"}},
                        {StepKind::magnetOff, {"upper electromagnet"}}});
}

// "Put the stone block where the spokes have to pass."
TEST(WhyMotor, ABlockIsWhyTheMotorStops) {
    Answer const answer = answerIn("3-electric-motor", "a block in its way");
    EXPECT_FALSE(answer.happened);
    std::string const words = told(answer);
    EXPECT_NE(words.find("Block 1 stood in the way of spoke "), std::string::npos) << words;
    EXPECT_NE(words.find("Without block 1, the goal would have been met"), std::string::npos) << words;
}

// 6.10.4: "It is also possible to model the electric motor with just four spokes", with the wires crossed.
TEST(WhyMotor, FourSpokesTurnItInTheSameWay) {
    Answer const answer = answerIn("3b-four-spokes", "hands off");
    ASSERT_TRUE(answer.happened);
    expectChain(answer, {{StepKind::contact, {"sliding contact", "spoke 1"}},
                         {StepKind::on, {"lower electromagnet"}},
                         {StepKind::magnetOn, {"lower electromagnet"}},
                         {StepKind::push, {"lower electromagnet"}},
                         {StepKind::contact, {"sliding contact", "spoke 4"}},
                         {StepKind::on, {"upper electromagnet"}},
                         {StepKind::magnetOn, {"upper electromagnet"}},
                         {StepKind::push, {"upper electromagnet"}},
                         {StepKind::contact, {"sliding contact", "spoke 2"}},
                         {StepKind::goal, {"spoke 1"}}});
    EXPECT_LT(placeIn(answer, StepKind::pull, {"lower electromagnet"}), answer.chain.size()) << told(answer);
    EXPECT_LT(placeIn(answer, StepKind::pull, {"upper electromagnet"}), answer.chain.size()) << told(answer);
}

// Held and let go, it starts again because the base magnet turns a spoke to the contact.
TEST(WhyMotor, TheBaseMagnetStartsItAgain) {
    Answer const answer = answerIn("3b-four-spokes", "hold the axle");
    ASSERT_TRUE(answer.happened);
    expectChain(answer, {{StepKind::push, {"base magnet"}},
                         {StepKind::contact, {"sliding contact"}},
                         {StepKind::on, {"upper electromagnet"}},
                         {StepKind::magnetOn, {"upper electromagnet"}},
                         {StepKind::goal, {"spoke 1"}}});
    expectChain(answer, {{StepKind::grabbed, {"spoke 1"}}, {StepKind::goal, {"spoke 1"}}});
    Answer const held = answerIn("3b-four-spokes", "hold the axle", {}, 0, true);
    ASSERT_TRUE(held.happened);
    expectChain(held, {{StepKind::grabbed, {"spoke 1"}}, {StepKind::goal, {"spoke 1"}}});
}

// "The base magnet always turns the main motor into a position where one of the spokes will collide with the
// sliding contact and thus close one of the electrical circuits".
TEST(WhyMotor, WithTheBaseMagnetItStarts) {
    Answer const answer = answerIn("3c-no-base-magnet", "put the base magnet back");
    ASSERT_TRUE(answer.happened);
    EXPECT_TRUE(answer.confirmed) << told(answer);
    expectChain(answer, {{StepKind::placed, {"base magnet 1"}},
                         {StepKind::push, {"base magnet 1"}},
                         {StepKind::pull, {"base magnet 1"}},
                         {StepKind::contact, {"sliding contact", "spoke 8"}},
                         {StepKind::on, {"lower electromagnet"}},
                         {StepKind::magnetOn, {"lower electromagnet"}},
                         {StepKind::pull, {"lower electromagnet"}},
                         {StepKind::push, {"lower electromagnet"}},
                         {StepKind::goal, {"spoke 1"}}});
}

// "Unless there is some external stimulus".
TEST(WhyMotor, WithoutTheBaseMagnetItNeedsAPush) {
    Answer const pushed = answerIn("3c-no-base-magnet", "give it a push");
    ASSERT_TRUE(pushed.happened);
    EXPECT_TRUE(pushed.confirmed) << told(pushed);
    expectChain(pushed, {{StepKind::grabbed, {"main axle"}}, {StepKind::goal, {"spoke 1"}}});
    Answer const rests = answerIn("3c-no-base-magnet", "nothing but a wooden bar");
    EXPECT_FALSE(rests.happened);
}

// 6.10.4: an object "if it rotates at a certain velocity" emits power, and so the lamp is lit by what turns
// the dynamo.
TEST(WhyMotor, TheDynamosLampIsLitBecauseTheDynamoTurns) {
    Answer const answer = answerIn("3d-motor-and-generator", "hands off");
    ASSERT_TRUE(answer.happened);
    expectChain(answer, {{StepKind::contact, {"object 1", "switch"}},
                         {StepKind::on, {"motor"}},
                         {StepKind::other, {"dynamo"}},
                         {StepKind::on, {"lamp"}},
                         {StepKind::goal, {"lamp"}}});
    EXPECT_EQ(answer.chain[placeIn(answer, StepKind::other, {"dynamo"})].step.what, "turns fast enough");
    EXPECT_NE(
        told(answer).find("because the dynamo turns fast enough, because current flows through the motor"),
        std::string::npos)
        << told(answer);
}

TEST(WhyMotor, TheDynamosLampGoesOutBecauseTheDynamoTurnsTooSlowly) {
    std::pair<std::string, Account> const alternatives[]{
        {"cut the wire", {{StepKind::cut, {"motor"}}, {StepKind::goal, {"lamp"}}}},
        {"hold the wheel", {{StepKind::grabbed, {"dynamo"}}, {StepKind::goal, {"lamp"}}}}};
    for (auto const& [solution, deed] : alternatives) {
        Answer const answer = answerIn("3d-motor-and-generator", solution, {}, 0, true);
        ASSERT_TRUE(answer.happened) << solution;
        EXPECT_TRUE(answer.confirmed) << told(answer);
        expectChain(answer, deed);
        expectChain(answer,
                    {{StepKind::other, {"dynamo"}}, {StepKind::off, {"lamp"}}, {StepKind::goal, {"lamp"}}});
        EXPECT_NE(told(answer).find("The lamp goes out, because the dynamo turns too slowly"),
                  std::string::npos)
            << told(answer);
    }
}

// The lamp's own circuit is whole: its dynamo stands still.
TEST(WhyMotor, ACutWireInTheMotorsCircuitIsNoGapInTheDynamos) {
    Answer const answer = answerIn("3d-motor-and-generator", "cut the wire before the switch falls");
    EXPECT_FALSE(answer.happened);
    std::string const words = told(answer);
    EXPECT_NE(words.find("the dynamo turned at 0 degrees a second"), std::string::npos) << words;
    EXPECT_EQ(words.find("between the dynamo and the motor"), std::string::npos) << words;
}

} // namespace
} // namespace why_motor
} // namespace trembler::insight
