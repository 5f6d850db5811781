// What cannot be written waits, whatever the write throws, and is tried again.
#include "game/ui/shared/kept/pending_writes.hpp"
#include "runtime/level/json/refuse_file.hpp"

#include <gtest/gtest.h>

#include <cerrno>
#include <new>
#include <system_error>

namespace trembler::ui {
namespace {

/// A write that fails in some way until it may succeed.
struct Trial {
    std::function<void()> fails;
    bool may = false;
    int tries = 0;
    int written = 0;

    PendingWrites::Write write() {
        return [this] {
            ++tries;
            if (!may) {
                fails();
            }
            ++written;
            return std::string("written");
        };
    }
};

TEST(PendingWrites, KeepWhateverAWriteThrowsAndSayWhy) {
    struct Case {
        std::function<void()> fails;
        char const* says;
    };
    for (Case const& one :
         {Case{[] { throw OutputError("/x/solution.json", ENOSPC); }, "the disk is full"},
          Case{[] { refuseFile("/x/level.json", "is a folder", "a file"); }, "/x/level.json"},
          Case{[] {
                   throw std::filesystem::filesystem_error(
                       "remove", "/x/y", std::make_error_code(std::errc::read_only_file_system));
               },
               "the disk is read-only (/x/y)"},
          Case{[] { throw std::bad_alloc(); }, "too little memory"},
          Case{[] { throw std::runtime_error("a strange reason"); }, "a strange reason"}}) {
        render::Toasts toasts;
        PendingWrites pending(toasts);
        Trial trial{one.fails};
        EXPECT_FALSE(pending.write(Owned::solution, trial.write()));
        EXPECT_EQ(pending.waiting(), 1U);
        EXPECT_NE(toasts.newest().find(one.says), std::string::npos) << toasts.newest();
        EXPECT_EQ(toasts.newest().find("filesystem error"), std::string::npos);
        EXPECT_EQ(toasts.newest().find("bad_alloc"), std::string::npos);
        std::size_t const said = toasts.count();
        for (int i = 0; i < 3; ++i) {
            EXPECT_NO_THROW(pending.pass(PendingWrites::patience));
        }
        EXPECT_NO_THROW(pending.finish());
        EXPECT_EQ(trial.tries, 5);
        EXPECT_EQ(toasts.count(), said) << "it is said once";
        EXPECT_EQ(pending.waiting(), 1U);
        trial.may = true;
        pending.pass(PendingWrites::patience);
        EXPECT_EQ(trial.written, 1);
        EXPECT_EQ(pending.waiting(), 0U);
        EXPECT_EQ(toasts.newest(), "written");
    }
}

TEST(PendingWrites, OneWithATroubleOfItsOwnKeepsNoOtherWaiting) {
    render::Toasts toasts;
    PendingWrites pending(toasts);
    Trial own{[] { throw std::runtime_error("its own trouble"); }};
    Trial full{[] { throw OutputError("/x", ENOSPC); }};
    Trial behind{[] { throw OutputError("/x", ENOSPC); }};
    for (Trial* const trial : {&own, &full, &behind}) {
        EXPECT_FALSE(pending.write(Owned::picture, trial->write()));
    }
    behind.may = true;
    pending.pass(PendingWrites::patience);
    EXPECT_EQ(behind.tries, 1) << "on a disk that is full it is not tried";
    full.may = true;
    pending.pass(PendingWrites::patience);
    EXPECT_EQ(full.written + behind.written, 2);
    EXPECT_EQ(pending.waiting(), 1U);
    own.may = true;
    pending.finish();
    EXPECT_EQ(own.written, 1);
    EXPECT_EQ(pending.waiting(), 0U);
}

TEST(PendingWrites, HaveBoundsAndSayWhatIsGivenUp) {
    render::Toasts toasts;
    PendingWrites pending(toasts);
    Trial trial{[] { throw OutputError("/x", ENOSPC); }};
    for (std::size_t i = 0; i < PendingWrites::mostPieces; ++i) {
        EXPECT_FALSE(pending.write(Owned::picture, trial.write(), 1000));
        EXPECT_NE(toasts.newest().find("tried again"), std::string::npos);
    }
    EXPECT_FALSE(pending.write(Owned::picture, trial.write(), 1000));
    EXPECT_NE(toasts.newest().find("not tried again"), std::string::npos) << toasts.newest();
    EXPECT_EQ(pending.waiting(), PendingWrites::mostPieces);
    PendingWrites large(toasts);
    EXPECT_FALSE(large.write(Owned::clip, trial.write(), PendingWrites::mostBytes));
    EXPECT_FALSE(large.write(Owned::clip, trial.write(), 1));
    EXPECT_EQ(large.waiting(), 1U);
}

} // namespace
} // namespace trembler::ui
