// The processes that share out work.
#pragma once

#include <string>
#include <vector>

namespace trembler::insight {

/// All members run the same program with the same arguments and reach the same calls of exchange() in the
/// same order. This base class is a team of one.
class Team {
public:
    Team() = default;
    virtual ~Team() = default;
    Team(Team const&) = delete;
    Team& operator=(Team const&) = delete;

    /// 0 to below size().
    [[nodiscard]] virtual int rank() const { return 0; }
    [[nodiscard]] virtual int size() const { return 1; }
    /// Gives every member the contributions of all members, by rank. Waits for all of them. From one thread.
    [[nodiscard]] virtual std::vector<std::string> exchange(std::string const& mine) { return {mine}; }
    /// The one that prints and writes files.
    [[nodiscard]] bool leads() const { return rank() == 0; }
};

} // namespace trembler::insight
