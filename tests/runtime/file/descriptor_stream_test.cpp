// An ordinary stream over a descriptor: every byte arrives for writes of any size, and a failure has a
// reason.
#include "runtime/file/descriptor_stream.hpp"
#include "runtime/file/visible_text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <memory>
#include <ostream>
#include <unistd.h>

namespace trembler {
namespace descriptor_stream_test {
namespace {

/// A file without a name, and its content.
class Paper {
public:
    Paper() : file_(std::tmpfile(), &std::fclose) {}
    [[nodiscard]] int descriptor() const { return ::fileno(file_.get()); }
    [[nodiscard]] std::string content() const {
        std::string all;
        std::array<char, 4096> piece{};
        for (ssize_t count = 1; count > 0;) {
            count = ::pread(descriptor(), piece.data(), piece.size(), static_cast<off_t>(all.size()));
            all.append(piece.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
        }
        return all;
    }

private:
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

TEST(DescriptorBuffer, EveryByteArrivesInOrder) {
    EXPECT_TRUE(rc::check("what was written stands there", [] {
        Paper const paper;
        std::string expected;
        {
            DescriptorBuffer buffer(paper.descriptor());
            std::ostream out(&buffer);
            for (int i = *rc::gen::inRange(0, 12); i > 0; --i) {
                // Around and beyond the size of the buffer.
                int const size = *rc::gen::element(0, 1, 2, 100, 32767, 32768, 32769, 100000);
                std::string const piece(static_cast<std::size_t>(size),
                                        *rc::gen::element('a', '\0', '\n', '\x1b', '\xff'));
                out << piece;
                expected += piece;
                if (*rc::gen::inRange(0, 3) == 0) {
                    out.put('|');
                    expected += '|';
                }
                if (*rc::gen::inRange(0, 3) == 0) {
                    out.flush();
                    RC_ASSERT(paper.content() == expected);
                }
            }
            RC_ASSERT(out.good());
            RC_ASSERT(buffer.error() == 0);
        }
        RC_ASSERT(paper.content() == expected);
    }));
}

// The shown text does not depend on the division of its bytes into buffers.
TEST(DescriptorBuffer, CharactersAcrossTwoBuffersAreShownWhole) {
    std::string const line = "caf\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x98\x80 \x1b[2J\n\t\xE2\x80\xAE"
                             "abc";
    for (std::size_t pad = 0; pad < line.size() + 4; ++pad) {
        std::string text(32768 - line.size() / 2 - pad % line.size(), 'x');
        text += line;
        text += line;
        Paper const paper;
        {
            DescriptorBuffer buffer(paper.descriptor(), DescriptorBuffer::Filter::visible);
            std::ostream out(&buffer);
            out << text;
        }
        EXPECT_EQ(paper.content(), visibleLines(text)) << pad;
    }
    for (std::size_t cut = 0; cut <= line.size(); ++cut) { // flushed in the middle of a character
        Paper const paper;
        {
            DescriptorBuffer buffer(paper.descriptor(), DescriptorBuffer::Filter::visible);
            std::ostream out(&buffer);
            out << line.substr(0, cut) << std::flush << line.substr(cut);
        }
        EXPECT_EQ(paper.content(), visibleLines(line)) << cut;
    }
    Paper const paper;
    {
        DescriptorBuffer buffer(paper.descriptor(), DescriptorBuffer::Filter::visible);
        std::ostream(&buffer) << "a\xE2\x82";
    }
    EXPECT_EQ(paper.content(), "a<E2><82>") << "an incomplete character is shown at the end";
}

TEST(DescriptorBuffer, AFailureIsKeptWithItsReason) {
    int const full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
    ASSERT_GE(full, 0);
    {
        DescriptorBuffer buffer(full);
        std::ostream out(&buffer);
        out << "too long";
        EXPECT_TRUE(out.good()) << "nothing has been written yet";
        EXPECT_EQ(buffer.error(), 0);
        out.flush();
        EXPECT_FALSE(out.good());
        EXPECT_EQ(buffer.error(), ENOSPC);
        out.clear();
        out << std::string(100000, 'x');
        EXPECT_FALSE(out.good()) << "no further write is attempted";
        EXPECT_EQ(buffer.error(), ENOSPC);
    }
    ::close(full);
    DescriptorBuffer closed(-1);
    std::ostream out(&closed);
    out << "x" << std::flush;
    EXPECT_EQ(closed.error(), EBADF);
}

} // namespace
} // namespace descriptor_stream_test
} // namespace trembler
