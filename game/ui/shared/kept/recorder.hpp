// Writes the player's clips, single pictures and plots.
#pragma once

#include <filesystem>
#include <string>

namespace trembler::ui {

/// Window thread only.
class Recorder {
public:
    /// Clips, pictures and plots go into files of `folder`.
    explicit Recorder(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Makes the folder and tries whether it takes files, so that a clip is not recorded that cannot be
    /// saved. Throws OutputError.
    void prepare() const;
    /// Writes a new file, NAME-1 with that ending and so on, and returns its path. Throws OutputError.
    [[nodiscard]] std::filesystem::path write(std::string const& name, std::string const& ending,
                                              std::string const& bytes) const;

private:
    std::filesystem::path folder_;
};

} // namespace trembler::ui
