#include "insight/timeline/words.hpp"

#include <algorithm>
#include <cstring>

namespace trembler::insight {

void WordWriter::text(std::string_view text) {
    word(text.size());
    for (std::size_t at = 0; at < text.size(); at += sizeof(std::uint64_t)) {
        std::uint64_t eight = 0;
        std::memcpy(&eight, text.data() + at, std::min(sizeof eight, text.size() - at));
        word(eight);
    }
}

void WordWriter::counts(CallerCounts const& counts) {
    std::vector<CallerCounts::Entry> const entries = counts.entries();
    word(entries.size());
    for (CallerCounts::Entry const& entry : entries) {
        word(static_cast<std::uint64_t>(entry.count));
        text(entry.caller.name());
    }
}

CallerNames::CallerNames(std::span<std::string const> names) {
    for (std::string const& name : names) {
        known_.push_back(callers_.add(name));
    }
}

CallerId CallerNames::of(std::string const& name) const {
    if (name == CallerId::level().name()) {
        return CallerId::level();
    }
    auto const at =
        std::find_if(known_.begin(), known_.end(), [&](CallerId id) { return id.name() == name; });
    return at == known_.end() ? CallerId() : *at;
}

std::string WordReader::text() {
    std::uint64_t const size = word();
    if (size > (words_.size() - at_) * sizeof(std::uint64_t)) {
        throw std::out_of_range("a recorded text is longer than its words");
    }
    std::string text(static_cast<std::size_t>(size), '\0');
    for (std::size_t at = 0; at < text.size(); at += sizeof(std::uint64_t)) {
        std::uint64_t const eight = word();
        std::memcpy(text.data() + at, &eight, std::min(sizeof eight, text.size() - at));
    }
    return text;
}

std::size_t WordReader::count() {
    std::uint64_t const size = word();
    if (size > words_.size() - at_) {
        throw std::out_of_range("a recorded list is longer than its words");
    }
    return static_cast<std::size_t>(size);
}

void WordReader::counts(CallerCounts& counts) {
    counts = {};
    for (std::size_t left = count(); left > 0; --left) {
        std::uint64_t const times = word();
        counts.add(callers_.of(text()), static_cast<std::int64_t>(times));
    }
}

} // namespace trembler::insight
