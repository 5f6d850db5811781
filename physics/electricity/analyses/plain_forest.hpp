// How the plain conductors of a circuit are connected to each other, for networks that share them.
#pragma once

#include "physics/electricity/core/network_members.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace trembler {

/// The forest of the blocks of the plain conductors (Harary and Prins 1966). A block is a largest set of
/// conductors of which any two are connected by two paths without a common conductor between them, or a
/// single connection. Nodes of the forest are the circuit's vertices, numbered as in the circuit, and after
/// them the blocks; a block is joined to its vertices. Vertices that are not plain are no part of it. So each
/// path between two plain conductors leads through the nodes between them in the forest.
class PlainForest {
public:
    static constexpr std::uint32_t none = 0xffffffffU;

    /// O(n log n).
    PlainForest(Circuit const& circuit, NetworkMembers const& members);

    [[nodiscard]] bool isBlock(std::uint32_t node) const { return node >= vertices_; }
    /// `none` at a root.
    [[nodiscard]] std::uint32_t parentOf(std::uint32_t node) const { return nodes_[node].parent; }
    /// The place of a node in a depth-first order of all nodes.
    [[nodiscard]] std::uint32_t placeOf(std::uint32_t node) const { return nodes_[node].place; }
    [[nodiscard]] bool sameTree(std::uint32_t a, std::uint32_t b) const {
        return nodes_[a].root == nodes_[b].root;
    }
    /// The lowest node that is above both, or one of them. Both must belong to one tree.
    [[nodiscard]] std::uint32_t commonAncestor(std::uint32_t a, std::uint32_t b) const;
    /// The child of `above` on the path to `below`, which is below it.
    [[nodiscard]] std::uint32_t childTowards(std::uint32_t above, std::uint32_t below) const;

    /// Marks that the nodes from `above` down to `below` carry current.
    void markPath(std::uint32_t above, std::uint32_t below) {
        ++paths_[below];
        --paths_[above];
    }
    void markBlock(std::uint32_t block) { live_[block - vertices_] = 1; }
    /// Sets `on` of all vertices on marked paths and in blocks that are marked or on marked paths. Once,
    /// after all marks. Linear.
    void apply(std::vector<std::uint8_t>& on);

private:
    struct Node {
        std::uint32_t parent = none;
        std::uint32_t root = none;
        std::uint32_t place = none;
        std::uint32_t depth = 0;
    };
    struct InBlock {
        std::uint32_t block = 0; // a node
        std::uint32_t vertex = 0;
        friend auto operator<=>(InBlock const&, InBlock const&) = default;
    };
    void findBlocks(Circuit const& circuit, NetworkMembers const& members);
    void makeTrees(NetworkMembers const& members);
    void makeTable();
    // The highest node in a range of places; if several are equally high, the last one.
    [[nodiscard]] std::uint32_t highest(std::uint32_t begin, std::uint32_t end) const;
    [[nodiscard]] std::uint32_t higher(std::uint32_t earlier, std::uint32_t later) const {
        return nodes_[earlier].depth < nodes_[later].depth ? earlier : later;
    }

    std::uint32_t vertices_;
    std::vector<InBlock> inBlocks_; // ascending
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;              // nodes by place
    std::vector<std::vector<std::uint32_t>> table_; // [k][p]: highest of the 2^k places from p
    std::vector<std::int32_t> paths_; // by node: paths that begin below it or in it, less the paths that end
    std::vector<std::uint8_t> live_;  // by block
};

} // namespace trembler
