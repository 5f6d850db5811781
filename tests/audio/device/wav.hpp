// Reads 16-bit .wav files without the library that writes them.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace trembler::test {

struct Wav {
    std::string bytes; ///< the whole file
    std::uint32_t rate = 0;
    std::uint16_t channels = 0;
    std::uint16_t bits = 0;
    std::vector<float> left; ///< -1 to 1
    std::vector<float> right;

    explicit Wav(std::filesystem::path const& file) {
        std::ifstream in(file, std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(in), {});
        if (bytes.size() < 12 || bytes.substr(0, 4) != "RIFF" || bytes.substr(8, 4) != "WAVE") {
            ADD_FAILURE() << file << " is not a .wav file";
            return;
        }
        for (std::size_t at = 12; at + 8 <= bytes.size();) {
            std::string const name = bytes.substr(at, 4);
            std::size_t const size = number<std::uint32_t>(at + 4);
            if (name == "fmt ") {
                channels = number<std::uint16_t>(at + 10);
                rate = number<std::uint32_t>(at + 12);
                bits = number<std::uint16_t>(at + 22);
            } else if (name == "data") {
                for (std::size_t n = at + 8; n + 4 <= at + 8 + size; n += 4) {
                    left.push_back(static_cast<float>(number<std::int16_t>(n)) / 32768);
                    right.push_back(static_cast<float>(number<std::int16_t>(n + 2)) / 32768);
                }
            }
            at += 8 + size + size % 2;
        }
    }

private:
    template <class T>
    [[nodiscard]] T number(std::size_t at) const {
        T value{};
        if (at + sizeof value <= bytes.size()) {
            std::memcpy(&value, bytes.data() + at, sizeof value); // x86 is little-endian like the file
        }
        return value;
    }
};

} // namespace trembler::test
