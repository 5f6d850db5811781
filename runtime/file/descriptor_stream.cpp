#include "runtime/file/descriptor_stream.hpp"

#include "runtime/file/file_calls.hpp"
#include "runtime/file/visible_text.hpp"

#include <algorithm>
#include <cerrno>
#include <sys/types.h>

namespace trembler {

DescriptorBuffer::DescriptorBuffer(int descriptor, Filter filter) : descriptor_(descriptor), filter_(filter) {
    setp(buffer_.data(), buffer_.data() + buffer_.size());
}

DescriptorBuffer::~DescriptorBuffer() {
    writeOut(true);
}

DescriptorBuffer::int_type DescriptorBuffer::overflow(int_type c) {
    if (!writeOut(false)) {
        return traits_type::eof();
    }
    if (!traits_type::eq_int_type(c, traits_type::eof())) {
        *pptr() = traits_type::to_char_type(c);
        pbump(1);
    }
    return traits_type::not_eof(c);
}

int DescriptorBuffer::sync() {
    return writeOut(false) ? 0 : -1;
}

bool DescriptorBuffer::writeOut(bool last) {
    std::string_view pending(pbase(), static_cast<std::size_t>(pptr() - pbase()));
    std::string kept;
    if (filter_ == Filter::visible) {
        if (!last) { // an incomplete character waits for the rest of its bytes
            std::size_t const tail = unfinishedCharacter(pending);
            kept = pending.substr(pending.size() - tail);
            pending.remove_suffix(tail);
        }
        writeAll(visibleLines(pending));
    } else {
        writeAll(pending);
    }
    setp(buffer_.data(), buffer_.data() + buffer_.size());
    std::copy(kept.begin(), kept.end(), buffer_.data());
    pbump(static_cast<int>(kept.size()));
    return error_ == 0;
}

bool DescriptorBuffer::writeAll(std::string_view bytes) {
    while (error_ == 0 && !bytes.empty()) {
        ssize_t const written = fileCalls().write(descriptor_, bytes.data(), bytes.size());
        if (written > 0) {
            bytes.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno != EINTR) {
            error_ = written == 0 ? EIO : errno;
        }
    }
    return error_ == 0;
}

} // namespace trembler
