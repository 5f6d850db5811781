// Standard output and standard error as this program uses them: no control character from a level, a name or
// an argument reaches a terminal, and a write that fails is noticed.
#pragma once

#include "runtime/file/descriptor_stream.hpp"

#include <iostream>

namespace trembler {

/// Stands between std::cout, std::cerr and their descriptors for as long as it lives. One, in main().
class StandardStreams {
public:
    StandardStreams();
    ~StandardStreams();
    StandardStreams(StandardStreams const&) = delete;
    StandardStreams& operator=(StandardStreams const&) = delete;

    /// Writes what is left. The exit status of the program: `status`, or that of a failure, which is said on
    /// standard error, if standard output could not be written.
    [[nodiscard]] int finish(int status);

private:
    DescriptorBuffer out_;
    DescriptorBuffer error_;
    std::streambuf* outBefore_;
    std::streambuf* errorBefore_;
};

} // namespace trembler
