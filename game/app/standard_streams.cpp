#include "game/app/standard_streams.hpp"

#include "game/app/commands.hpp"

#include <csignal>
#include <system_error>
#include <unistd.h>

namespace trembler {

StandardStreams::StandardStreams()
    : out_(STDOUT_FILENO, DescriptorBuffer::Filter::visible),
      error_(STDERR_FILENO, DescriptorBuffer::Filter::visible), outBefore_(std::cout.rdbuf(&out_)),
      errorBefore_(std::cerr.rdbuf(&error_)) {
    std::signal(SIGXFSZ, SIG_IGN); // exceeding the file size limit becomes a failed write, which is reported
}

StandardStreams::~StandardStreams() {
    std::cout.rdbuf(outBefore_);
    std::cerr.rdbuf(errorBefore_);
}

int StandardStreams::finish(int status) {
    std::cout.flush();
    if (out_.error() == 0) {
        return status;
    }
    std::cerr << "trembler: standard output: cannot be written: "
              << std::generic_category().message(out_.error()) << "\n";
    return exitBadInput;
}

} // namespace trembler
