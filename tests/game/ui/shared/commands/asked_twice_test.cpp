// Commands that lose data must be confirmed by a second request.
#include "game/ui/shared/commands/asked_twice.hpp"

#include <gtest/gtest.h>

namespace trembler::ui::test {
namespace {

TEST(AskedTwice, TheSecondRequestConfirms) {
    AskedTwice question;
    EXPECT_FALSE(question.waiting());
    EXPECT_FALSE(question.ask());
    EXPECT_TRUE(question.waiting());
    question.pass(1);
    EXPECT_TRUE(question.ask());
    EXPECT_FALSE(question.waiting());
    EXPECT_FALSE(question.ask()) << "another time is another question";
}

TEST(AskedTwice, TheQuestionExpires) {
    AskedTwice question;
    EXPECT_FALSE(question.ask());
    question.pass(0.75 * AskedTwice::patience);
    EXPECT_TRUE(question.waiting());
    question.pass(0.75 * AskedTwice::patience);
    EXPECT_FALSE(question.waiting());
    EXPECT_FALSE(question.ask());
    question.pass(0.75 * AskedTwice::patience);
    EXPECT_TRUE(question.waiting()) << "its time begins when it is asked";
    question.forget();
    EXPECT_FALSE(question.ask());
}

} // namespace
} // namespace trembler::ui::test
