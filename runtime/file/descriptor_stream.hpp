// Writing to a file descriptor with an ordinary stream that knows why writing failed.
#pragma once

#include <array>
#include <streambuf>
#include <string>

namespace trembler {

/// Buffers what is written and hands it to a descriptor, which it does not own. After a failure nothing more
/// is written, the stream goes bad and the reason is kept. One thread at a time.
class DescriptorBuffer final : public std::streambuf {
public:
    enum class Filter {
        none,
        visible, ///< through visibleLines(): for what may be a terminal
    };
    explicit DescriptorBuffer(int descriptor, Filter filter = Filter::none);
    /// Writes what is left; a failure is then lost, so flush and ask before.
    ~DescriptorBuffer() override;
    DescriptorBuffer(DescriptorBuffer const&) = delete;
    DescriptorBuffer& operator=(DescriptorBuffer const&) = delete;

    /// The errno of the first write that failed; 0: none did.
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
