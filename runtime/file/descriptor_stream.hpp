// A stream buffer that writes to a file descriptor and keeps the reason of a failure.
#pragma once

#include <array>
#include <streambuf>
#include <string>

namespace trembler {

/// Buffers output and writes it to a descriptor, which it does not own. After a failure nothing more is
/// written, the stream goes bad and the reason is kept. One thread at a time.
class DescriptorBuffer final : public std::streambuf {
public:
    enum class Filter {
        none,
        visible, ///< through visibleLines(): for descriptors that may be a terminal
    };
    explicit DescriptorBuffer(int descriptor, Filter filter = Filter::none);
    /// Writes the rest of the buffer. A failure of this write is lost, so flush and check error() before.
    ~DescriptorBuffer() override;
    DescriptorBuffer(DescriptorBuffer const&) = delete;
    DescriptorBuffer& operator=(DescriptorBuffer const&) = delete;

    /// The errno of the first write that failed; 0 if none has.
    [[nodiscard]] int error() const { return error_; }

protected:
    int_type overflow(int_type c) override;
    int sync() override;

private:
    bool writeOut(bool last);
    bool writeAll(std::string_view bytes);

    int descriptor_;
    Filter filter_;
    int error_ = 0;
    std::array<char, 1U << 15U> buffer_{};
};

} // namespace trembler
