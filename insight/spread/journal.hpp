// The finished work of a long command, written as it comes, so that a later run can go on with it.
#pragma once

#include "insight/spread/team.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>

namespace trembler::insight {

/// A file of JSON lines, {"work": KEY, "result": TEXT}, one for each finished piece of work. A line that is
/// incomplete, because the program was killed while writing it, is left out. Every member of a team but the
/// leader writes a file of its own, with its rank added to the name, because several machines cannot safely
/// append to one file; the leader reads all of them. Thread-safe.
class Journal {
public:
    /// Bytes of a line; of all files together.
    static constexpr std::size_t longestLine = std::size_t{1} << 20U;
    static constexpr std::uintmax_t mostBytes = std::uintmax_t{512} << 20U;

    /// Reads the existing lines; all members of the team must do so at the same time. Throws OutputError if
    /// the file cannot be written, std::invalid_argument if it holds anything but such lines, or more than
    /// the limits allow.
    Journal(std::filesystem::path file, Team& team);
    ~Journal();
    Journal(Journal const&) = delete;
    Journal& operator=(Journal const&) = delete;

    /// The result of a piece of work that is finished. Results that add() has added are not among them:
    /// within one run of the program no work is done twice.
    [[nodiscard]] std::optional<std::string> find(std::string const& key) const;
    [[nodiscard]] std::size_t size() const { return known_.size(); }
    /// Adds one, unless its line would be too long to be read: that work is done again. Is on its way to the
    /// disk when it returns: killing the program does not lose it. Throws OutputError.
    void add(std::string const& key, std::string const& result);

private:
    void read(std::filesystem::path const& file);

    std::filesystem::path file_;
    std::uintmax_t bytes_ = 0; // of the files that were read
    std::map<std::string, std::string> known_;
    std::mutex mutex_;
    int descriptor_ = -1;
};

} // namespace trembler::insight
