#include "physics/electricity/analyses/plain_forest.hpp"

#include "physics/electricity/analyses/blocks.hpp"

#include <algorithm>
#include <bit>

namespace trembler {

PlainForest::PlainForest(Circuit const& circuit, NetworkMembers const& members) : vertices_(circuit.size()) {
    findBlocks(circuit, members);
    makeTrees(members);
    makeTable();
    paths_.assign(nodes_.size(), 0);
    live_.assign(nodes_.size() - vertices_, 0);
}

void PlainForest::findBlocks(Circuit const& circuit, NetworkMembers const& members) {
    std::vector<BlockEdge> edges;
    for (std::uint32_t const v : members.plain()) {
        for (std::uint32_t const w : members.plainNeighboursOf(v)) {
            edges.push_back({v, w});
        }
    }
    std::vector<std::size_t> const blocks = blocksOf(edges, circuit.size());
    std::size_t count = 0;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        if (blocks[e] != noBlock) {
            auto const block = static_cast<std::uint32_t>(vertices_ + blocks[e]);
            inBlocks_.push_back({block, edges[e].first});
            inBlocks_.push_back({block, edges[e].second});
            count = std::max(count, blocks[e] + 1);
        }
    }
    std::sort(inBlocks_.begin(), inBlocks_.end());
    inBlocks_.erase(std::unique(inBlocks_.begin(), inBlocks_.end()), inBlocks_.end());
    nodes_.resize(vertices_ + count);
}

void PlainForest::makeTrees(NetworkMembers const& members) {
    std::vector<std::uint32_t> begins(nodes_.size() + 1, 0);
    for (InBlock const& pair : inBlocks_) {
        ++begins[pair.block + 1];
        ++begins[pair.vertex + 1];
    }
    for (std::size_t node = 1; node < begins.size(); ++node) {
        begins[node] += begins[node - 1];
    }
    std::vector<std::uint32_t> neighbours(2 * inBlocks_.size());
    std::vector<std::uint32_t> next(begins.begin(), begins.end() - 1);
    for (InBlock const& pair : inBlocks_) {
        neighbours[next[pair.block]++] = pair.vertex;
        neighbours[next[pair.vertex]++] = pair.block;
    }
    std::vector<std::uint32_t> open; // the next node is the last one
    for (std::uint32_t const root : members.plain()) {
        if (nodes_[root].root != none) {
            continue;
        }
        nodes_[root].root = root;
        open.push_back(root);
        while (!open.empty()) {
            std::uint32_t const node = open.back();
            open.pop_back();
            nodes_[node].place = static_cast<std::uint32_t>(order_.size());
            order_.push_back(node);
            for (std::uint32_t i = begins[node]; i < begins[node + 1]; ++i) {
                Node& other = nodes_[neighbours[i]];
                if (neighbours[i] != nodes_[node].parent) {
                    other = {node, root, none, nodes_[node].depth + 1};
                    open.push_back(neighbours[i]);
                }
            }
        }
    }
}

void PlainForest::makeTable() {
    table_.push_back(order_);
    for (std::size_t step = 1; 2 * step <= order_.size(); step *= 2) {
        std::vector<std::uint32_t> const& half = table_.back();
        std::vector<std::uint32_t> whole(order_.size() - 2 * step + 1);
        for (std::size_t place = 0; place < whole.size(); ++place) {
            whole[place] = higher(half[place], half[place + step]);
        }
        table_.push_back(std::move(whole));
    }
}

std::uint32_t PlainForest::highest(std::uint32_t begin, std::uint32_t end) const {
    auto const k = static_cast<std::size_t>(std::bit_width(end - begin)) - 1;
    return higher(table_[k][begin], table_[k][end - (std::uint32_t{1} << k)]);
}

// Among the nodes between two nodes in a depth-first order, the highest one is a child of their common
// ancestor.
std::uint32_t PlainForest::commonAncestor(std::uint32_t a, std::uint32_t b) const {
    if (a == b) {
        return a;
    }
    auto const [first, last] = std::minmax(nodes_[a].place, nodes_[b].place);
    return nodes_[highest(first + 1, last + 1)].parent;
}

std::uint32_t PlainForest::childTowards(std::uint32_t above, std::uint32_t below) const {
    return highest(nodes_[above].place + 1, nodes_[below].place + 1);
}

void PlainForest::apply(std::vector<std::uint8_t>& on) {
    auto const set = [&](std::uint32_t node) {
        if (isBlock(node)) {
            markBlock(node);
        } else {
            on[node] = 1;
        }
    };
    for (auto node = order_.rbegin(); node != order_.rend(); ++node) { // children before parents
        if (std::uint32_t const parent = nodes_[*node].parent; parent != none && paths_[*node] > 0) {
            set(*node);
            set(parent);
            paths_[parent] += paths_[*node];
        }
    }
    for (InBlock const& pair : inBlocks_) {
        if (live_[pair.block - vertices_] != 0) {
            on[pair.vertex] = 1;
        }
    }
}

} // namespace trembler
