#include "physics/inverse_square/tree.hpp"

#include <algorithm>
#include <bit>

namespace trembler::inverse_square {
namespace {

constexpr std::uint32_t leafSize = 8;
constexpr std::uint32_t notWorthACluster = 2; // so few sources cost less than their moments

} // namespace

// The clusters that a group sums as wholes, and the points that it sums one by one.
struct Tree::Lists {
    std::vector<Cluster> far;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> near; // ranges of sources
    std::vector<std::uint32_t> own; // sources of the group's own objects outside its box, ascending

    void addNear(std::uint32_t begin, std::uint32_t end) {
        if (!near.empty() && near.back().second == begin) {
            near.back().second = end;
        } else {
            near.emplace_back(begin, end);
        }
    }
    [[nodiscard]] bool holdsOwn(std::uint32_t begin, std::uint32_t end) const {
        auto const first = std::lower_bound(own.begin(), own.end(), begin);
        return first != own.end() && *first < end;
    }
};

void Tree::build(Points const& sources) {
    orderAlongCurve(sources, order_);
    copyInOrder(sources, order_, sources_);
    nodes_.clear();
    owned_.clear();
    if (!sources_.empty()) {
        grow(0, static_cast<std::uint32_t>(sources_.size()));
    }
}

// Returns the row of the node over the sources in [begin, end).
std::uint32_t Tree::grow(std::uint32_t begin, std::uint32_t end) {
    auto const at = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    nodes_[at].begin = begin;
    nodes_[at].end = end;
    std::uint64_t const differing = order_[begin].key ^ order_[end - 1].key;
    if (end - begin <= leafSize || differing == 0) {
        sumLeaf(nodes_[at]);
        nodes_[at].skip = at + 1;
        return at;
    }
    // The coarsest square that all of them share is left out: a node with a single child has no information.
    unsigned const shift = (63U - static_cast<unsigned>(std::countl_zero(differing))) & ~1U;
    std::uint32_t from = begin;
    while (from < end) {
        std::uint64_t const quadrant = order_[from].key >> shift;
        auto const next =
            std::partition_point(order_.begin() + from, order_.begin() + end,
                                 [&](Ordered const& o) { return (o.key >> shift) == quadrant; });
        auto const to = static_cast<std::uint32_t>(next - order_.begin());
        grow(from, to);
        from = to;
    }
    nodes_[at].skip = static_cast<std::uint32_t>(nodes_.size());
    sumChildren(at);
    return at;
}

void Tree::sumLeaf(Node& node) const {
    Vec2 weighted;
    Vec2 plain;
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
        double const size = std::abs(sources_.weight[i]);
        node.cluster.absolute += size;
        node.cluster.weight += sources_.weight[i];
        weighted += size * sources_.at(i);
        plain += sources_.at(i);
    }
    Vec2 const centre =
        node.cluster.absolute > 0 ? weighted / node.cluster.absolute : plain / (node.end - node.begin);
    Cluster& c = node.cluster;
    c.x = centre.x;
    c.y = centre.y;
    double farthest = 0;
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
        Vec2 const d = sources_.at(i) - centre;
        double const w = sources_.weight[i];
        c.dipoleX += w * d.x;
        c.dipoleY += w * d.y;
        c.xx += w * d.x * d.x;
        c.xy += w * d.x * d.y;
        c.yy += w * d.y * d.y;
        farthest = std::max(farthest, lengthSquared(d));
    }
    node.radius = std::sqrt(farthest);
}

void Tree::sumChildren(std::uint32_t at) {
    Node& node = nodes_[at];
    Vec2 weighted;
    Vec2 plain;
    for (std::uint32_t child = at + 1; child < node.skip; child = nodes_[child].skip) {
        Node const& part = nodes_[child];
        Vec2 const centre{part.cluster.x, part.cluster.y};
        node.cluster.absolute += part.cluster.absolute;
        node.cluster.weight += part.cluster.weight;
        weighted += part.cluster.absolute * centre;
        plain += static_cast<double>(part.end - part.begin) * centre;
    }
    Vec2 const centre =
        node.cluster.absolute > 0 ? weighted / node.cluster.absolute : plain / (node.end - node.begin);
    Cluster& c = node.cluster;
    c.x = centre.x;
    c.y = centre.y;
    for (std::uint32_t child = at + 1; child < node.skip; child = nodes_[child].skip) {
        Node const& part = nodes_[child];
        Cluster const& p = part.cluster;
        Vec2 const t = Vec2{p.x, p.y} - centre;
        c.dipoleX += p.dipoleX + p.weight * t.x;
        c.dipoleY += p.dipoleY + p.weight * t.y;
        c.xx += p.xx + 2 * p.dipoleX * t.x + p.weight * t.x * t.x;
        c.xy += p.xy + p.dipoleX * t.y + p.dipoleY * t.x + p.weight * t.x * t.y;
        c.yy += p.yy + 2 * p.dipoleY * t.y + p.weight * t.y * t.y;
        node.radius = std::max(node.radius, part.radius + length(t));
    }
}

void Tree::setReceivers(Points const& receivers, bool ownElsewhere) {
    orderAlongCurve(receivers, receiverOrder_);
    copyInOrder(receivers, receiverOrder_, receivers_);
    ownElsewhere_ = ownElsewhere;
    if (ownElsewhere && owned_.empty()) {
        for (std::uint32_t i = 0; i < sources_.size(); ++i) {
            owned_.emplace_back(sources_.owner[i], i);
        }
        std::sort(owned_.begin(), owned_.end());
    }
}

// No cluster may contain sources of a receiver's own object. Clusters inside the box are never summed as
// wholes anyway.
void Tree::ownOutside(std::size_t begin, std::size_t end, Box const& box,
                      std::vector<std::uint32_t>& own) const {
    own.clear();
    for (std::size_t i = begin; i < end; ++i) {
        double const owner = receivers_.owner[i];
        for (auto at = std::lower_bound(owned_.begin(), owned_.end(), std::pair{owner, 0U});
             at != owned_.end() && at->first == owner; ++at) {
            Vec2 const p = sources_.at(at->second);
            if (p.x < box.low.x || p.x > box.high.x || p.y < box.low.y || p.y > box.high.y) {
                own.push_back(at->second);
            }
        }
    }
    std::sort(own.begin(), own.end());
}

void Tree::walk(Box const& box, double openingAngle, Lists& lists) const {
    lists.far.clear();
    lists.near.clear();
    for (std::uint32_t at = 0; at < nodes_.size();) {
        Node const& node = nodes_[at];
        std::uint32_t const count = node.end - node.begin;
        if (count > notWorthACluster) {
            double const dx = std::max({box.low.x - node.cluster.x, node.cluster.x - box.high.x, 0.0});
            double const dy = std::max({box.low.y - node.cluster.y, node.cluster.y - box.high.y, 0.0});
            double const reach2 = openingAngle * openingAngle * (dx * dx + dy * dy);
            if (node.radius * node.radius < reach2 && !lists.holdsOwn(node.begin, node.end)) {
                lists.far.push_back(node.cluster);
                at = node.skip;
                continue;
            }
        }
        if (node.skip == at + 1) {
            lists.addNear(node.begin, node.end);
        }
        ++at;
    }
}

void Tree::add(std::size_t begin, std::size_t end, double openingAngle, double softening2,
               std::span<Vec2> totals, std::span<double> stiffness) const {
    Kernels const& run = kernels();
    Lists lists;
    Block block;
    for (std::size_t group = begin; group < end; group += groupSize) {
        std::size_t const past = std::min(end, group + groupSize);
        Box box{receivers_.at(group), receivers_.at(group)};
        for (std::size_t i = group; i < past; ++i) {
            box.low = {std::min(box.low.x, receivers_.x[i]), std::min(box.low.y, receivers_.y[i])};
            box.high = {std::max(box.high.x, receivers_.x[i]), std::max(box.high.y, receivers_.y[i])};
        }
        if (ownElsewhere_) {
            ownOutside(group, past, box, lists.own);
        }
        walk(box, openingAngle, lists);
        for (std::size_t i = group; i < past; i += blockSize) {
            std::size_t const count = std::min(blockSize, past - i);
            auto const row = [i](std::size_t k) { return i + k; };
            auto const totalRow = [&](std::size_t k) { return receiverOrder_[i + k].row; };
            fillBlock(block, receivers_, totals, count, row, totalRow);
            run.addClusters(lists.far, softening2, block);
            for (auto const& [from, to] : lists.near) {
                run.addPairs(sources_, from, to, softening2, block);
            }
            emptyBlock(block, totals, stiffness, count, totalRow);
        }
    }
}

} // namespace trembler::inverse_square
