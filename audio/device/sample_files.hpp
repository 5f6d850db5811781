// Recordings from files, by libsndfile.
#pragma once

#include "audio/synth/recording.hpp"

#include <filesystem>
#include <functional>
#include <map>

namespace trembler {

/// Reads each file once and keeps it. Several channels are mixed to one. A file that is missing, damaged, no
/// sound file or longer than ten minutes is reported once, in words, and is then silent.
class SampleFiles final : public SampleSource {
public:
    using Report = std::function<void(std::string const&)>;

    /// Searches `folders` in order. `report` may be empty.
    explicit SampleFiles(std::vector<std::filesystem::path> folders, Report report = {});

    [[nodiscard]] std::shared_ptr<SampleData const> find(std::string const& file) override;

private:
    [[nodiscard]] std::shared_ptr<SampleData const> read(std::string const& file) const;

    std::vector<std::filesystem::path> folders_;
    Report report_;
    std::map<std::string, std::shared_ptr<SampleData const>> known_;
};

} // namespace trembler
