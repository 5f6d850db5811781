#include "insight/timeline/packed_frames.hpp"

#include <algorithm>
#include <stdexcept>
#include <zlib.h>

namespace trembler::insight {
namespace {

constexpr std::size_t wordBytes = sizeof(std::uint64_t);

/// The two latest values of a part, from which the next one is predicted.
struct Past {
    SharedWords last;
    SharedWords before; // the last one that differed from it

    /// The value of a word if it changed again as it did before.
    [[nodiscard]] std::uint64_t expected(std::size_t at) const {
        if (!last || at >= last->size()) {
            return 0;
        }
        std::uint64_t const now = (*last)[at];
        return before && at < before->size() ? 2 * now - (*before)[at] : now;
    }
    void pass(SharedWords next) {
        before = std::move(last);
        last = std::move(next);
    }
};

/// How a part of a frame is stored.
enum Kind : std::uint64_t { same, absent, stated };

/// Small for small positive and negative numbers.
std::uint64_t folded(std::uint64_t difference) {
    return (difference << 1U) ^ (0 - (difference >> 63U));
}
std::uint64_t unfolded(std::uint64_t word) {
    return (word >> 1U) ^ (0 - (word & 1U));
}

/// Puts the bytes of equal weight of all words side by side: most of the high ones are zero.
std::string sorted(Words const& words) {
    std::string bytes(words.size() * wordBytes, '\0');
    for (std::size_t weight = 0; weight < wordBytes; ++weight) {
        char* const plane = bytes.data() + weight * words.size();
        for (std::size_t i = 0; i < words.size(); ++i) {
            plane[i] = static_cast<char>(words[i] >> (8 * weight));
        }
    }
    return bytes;
}

Words unsorted(std::string const& bytes) {
    Words words(bytes.size() / wordBytes, 0);
    for (std::size_t weight = 0; weight < wordBytes; ++weight) {
        char const* const plane = bytes.data() + weight * words.size();
        for (std::size_t i = 0; i < words.size(); ++i) {
            words[i] |= std::uint64_t{static_cast<unsigned char>(plane[i])} << (8 * weight);
        }
    }
    return words;
}

std::string deflated(std::string const& bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::string packed(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                  reinterpret_cast<Bytef const*>(bytes.data()), static_cast<uLong>(bytes.size()),
                  Z_BEST_SPEED) != Z_OK) {
        throw std::runtime_error("a recording cannot be compressed: zlib has no memory");
    }
    packed.resize(size);
    packed.shrink_to_fit();
    return packed;
}

std::string inflated(std::string const& packed, std::size_t bytes) {
    std::string all(bytes, '\0');
    uLongf size = static_cast<uLongf>(bytes);
    if (uncompress(reinterpret_cast<Bytef*>(all.data()), &size, reinterpret_cast<Bytef const*>(packed.data()),
                   static_cast<uLong>(packed.size())) != Z_OK ||
        size != bytes) {
        throw std::runtime_error("a recording cannot be read: its compressed frames are damaged");
    }
    return all;
}

bool equal(SharedWords const& a, SharedWords const& b) {
    return a == b || (a && b && *a == *b);
}

} // namespace

PackedFrames::PackedFrames(std::span<RecordedFrame const> frames) {
    Words stream;
    std::vector<Past> past;
    for (RecordedFrame const& frame : frames) {
        numbers_.push_back(frame.number);
        stream.push_back(frame.values.size());
        past.resize(std::max(past.size(), frame.values.size()));
        for (std::size_t part = 0; part < frame.values.size(); ++part) {
            SharedWords const& value = frame.values[part];
            Past& known = past[part];
            if (equal(value, known.last)) {
                stream.push_back(same);
                continue;
            }
            stream.push_back(value ? stated : absent);
            if (value) {
                stream.push_back(folded(value->size() - (known.last ? known.last->size() : 0)));
                for (std::size_t i = 0; i < value->size(); ++i) {
                    stream.push_back(folded((*value)[i] - known.expected(i)));
                }
            }
            known.pass(value);
        }
    }
    words_ = stream.size();
    packed_ = deflated(sorted(stream));
}

std::vector<RecordedFrame> PackedFrames::unpacked() const {
    Words const stream = unsorted(inflated(packed_, static_cast<std::size_t>(words_) * wordBytes));
    auto next = stream.begin();
    std::vector<RecordedFrame> frames;
    std::vector<Past> past;
    for (std::uint64_t const number : numbers_) {
        RecordedFrame& frame = frames.emplace_back();
        frame.number = number;
        frame.values.resize(static_cast<std::size_t>(*next++));
        past.resize(std::max(past.size(), frame.values.size()));
        for (std::size_t part = 0; part < frame.values.size(); ++part) {
            Past& known = past[part];
            std::uint64_t const kind = *next++;
            if (kind == stated) {
                std::size_t const before = known.last ? known.last->size() : 0;
                Words words(static_cast<std::size_t>(unfolded(*next++) + before));
                for (std::size_t i = 0; i < words.size(); ++i) {
                    words[i] = unfolded(*next++) + known.expected(i);
                }
                known.pass(std::make_shared<Words const>(std::move(words)));
            } else if (kind == absent) {
                known.pass(nullptr);
            }
            frame.values[part] = known.last;
        }
    }
    return frames;
}

} // namespace trembler::insight
