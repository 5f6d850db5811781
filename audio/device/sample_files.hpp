// Recordings from files, by libsndfile.
#pragma once

#include "audio/synth/recording.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <utility>

namespace trembler {

/// How much recordings may hold. One that would exceed a limit is refused before it is decoded, by the length
/// that its file states.
struct SampleLimits {
    double seconds = 600;                        ///< of one recording
    std::size_t bytes = std::size_t{128} << 20U; ///< of one recording in memory: ten minutes at 48 kHz
    std::size_t inAll = std::size_t{512} << 20U; ///< bytes of all recordings in memory
};

/// Reads each file once, however its path is spelled, and keeps it. Several channels are mixed to one. A file
/// that is missing, damaged, no sound file or beyond a limit is reported once, in words, and is then silent.
class SampleFiles final : public SampleSource {
public:
    using Report = std::function<void(std::string const&)>;

    /// Searches `folders` in order. `report` may be empty.
    explicit SampleFiles(std::vector<std::filesystem::path> folders, Report report = {},
                         SampleLimits const& limits = {});

    [[nodiscard]] std::shared_ptr<SampleData const> find(std::string const& file) override;

    /// From now on recordings that were found before, and that nobody plays, make room for others; those that
    /// did not fit are tried again. To be called between levels.
    void newLevel();

    /// Bytes of the samples in memory.
    [[nodiscard]] std::size_t bytes() const { return bytes_; }

private:
    using Identity = std::pair<std::uint64_t, std::uint64_t>; // device and inode
    struct Known {
        std::shared_ptr<SampleData const> data; // nullptr: it cannot be played
        std::uint64_t level = 0;                // in which it was found last
    };

    [[nodiscard]] std::filesystem::path pathOf(std::string const& file) const;
    /// Throws std::runtime_error with the reason if it cannot be played.
    [[nodiscard]] std::shared_ptr<SampleData const> read(std::filesystem::path const& path);
    /// Throws if there is no room for so many samples.
    void makeRoom(std::size_t samples);
    void report(std::string const& file, std::string const& why);

    std::vector<std::filesystem::path> folders_;
    Report report_;
    SampleLimits limits_;
    std::map<std::string, Identity> names_; // of files that were found
    std::map<Identity, Known> known_;
    std::set<std::string> missing_;
    std::set<std::string> reported_;
    std::size_t bytes_ = 0;
    std::uint64_t level_ = 0;
};

} // namespace trembler
