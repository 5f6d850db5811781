// Standard output and standard error of this program: control characters from a level, a name or an argument
// never reach a terminal, and failed writes are noticed.
#pragma once

#include "runtime/file/descriptor_stream.hpp"

#include <iostream>

namespace trembler {

/// Filters std::cout and std::cerr for as long as it lives. One instance, in main().
class StandardStreams {
public:
    StandardStreams();
    ~StandardStreams();
    StandardStreams(StandardStreams const&) = delete;
    StandardStreams& operator=(StandardStreams const&) = delete;

    /// Flushes both streams. Returns the exit status of the program: `status`, or that of a failure, which is
    /// reported on standard error, if standard output could not be written.
    [[nodiscard]] int finish(int status);

private:
    DescriptorBuffer out_;
    DescriptorBuffer error_;
    std::streambuf* outBefore_;
    std::streambuf* errorBefore_;
};

} // namespace trembler
