// Two cheapest paths from a vertex to two ends that share no other vertex.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace trembler::insight {

/// An undirected graph with costs, in which each vertex but the first can be on one path only. A
/// minimum-cost flow of two units by shortest paths, with each vertex split into an entry and an exit
/// (Suurballe 1974; Bhandari 1999). O(V E) each in the worst case, in practice close to O(E). Of paths of
/// equal cost it finds those of the links that were added first. Not thread-safe.
class TwoPaths {
public:
    enum class End : std::uint8_t { first, second };

    explicit TwoPaths(std::size_t vertices);
    /// One of the paths has to end at a vertex that is such an end. A vertex may be both; then it serves as
    /// one of them only.
    void endsAt(std::size_t vertex, End end);
    /// Links two vertices; the cost is not negative. `name` is what from() returns for it.
    void link(std::size_t a, std::size_t b, double cost, std::size_t name);
    /// The links of a cheapest path from the vertex to a first end and of one to a second end, or of the
    /// first one only; ascending by name; nothing if there are no such paths. If the vertex is an end itself,
    /// its own path has no links. To be called once.
    [[nodiscard]] std::optional<std::vector<std::size_t>> from(std::size_t vertex, bool firstOnly);

private:
    struct Edge {
        std::size_t to = 0;
        int room = 0;
        double cost = 0;
        std::size_t back = 0; ///< the opposite edge, in edges_ of `to`
        std::size_t name = none;
    };
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    void edge(std::size_t from, std::size_t to, int room, double cost, std::size_t name);
    [[nodiscard]] bool augment(std::size_t source);
    [[nodiscard]] static std::size_t entry(std::size_t vertex) { return 2 * vertex; }
    [[nodiscard]] static std::size_t exit(std::size_t vertex) { return 2 * vertex + 1; }

    std::size_t sink_;
    std::vector<std::vector<Edge>> edges_;
};

} // namespace trembler::insight
