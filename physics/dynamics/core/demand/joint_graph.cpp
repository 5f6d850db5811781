#include "physics/dynamics/core/demand/joint_graph.hpp"

#include <algorithm>

namespace trembler {
namespace {

bool carries(Joint const& joint) {
    return joint.form != JointForm::gear && joint.form != JointForm::spring;
}

class Walk {
public:
    Walk(DynamicsColumns const& columns, BodyTable const& bodies, JointTable const& joints,
         std::span<LoadSum const> loads)
        : bodies_(bodies), loads_(joints.joints().size()), nodes_(bodies.bodies().size() + 1) {
        ground_ = nodes_.size() - 1;
        for (SlotIndex slot = 0; slot < ground_; ++slot) {
            Body const& body = bodies[slot];
            if (body.object.valid() && !body.fixed) {
                nodes_[slot].mass = body.mass;
                nodes_[slot].moment =
                    body.mass * worldCentre(body, columns.position.values()[body.rows.position].value,
                                            columns.rotation.values()[body.rows.rotation].angle);
                if (slot < loads.size()) {
                    nodes_[slot].force = loads[slot].load.force;
                    nodes_[slot].pulls = length(loads[slot].load.force);
                }
            }
        }
        std::span<TiedJoint const> const all = joints.joints();
        for (std::size_t slot = 0; slot < all.size(); ++slot) {
            if (all[slot].object.valid() && carries(all[slot].joint)) {
                std::size_t const a = nodeOf(all[slot].a);
                std::size_t const b = nodeOf(all[slot].b);
                nodes_[a].edges.push_back({b, slot});
                nodes_[b].edges.push_back({a, slot});
            }
        }
    }

    std::vector<JointLoad> run() {
        walk(ground_);
        for (std::size_t node = 0; node < ground_; ++node) {
            if (nodes_[node].order == 0) {
                walk(node);
            }
        }
        return std::move(loads_);
    }

private:
    struct Edge {
        std::size_t to;
        std::size_t joint;
    };
    struct Node {
        double mass = 0;  // with all nodes below it in the walk, once these are finished
        Vec2 moment;      // mass times place
        Vec2 force;       // N
        double pulls = 0; // N, sum of the magnitudes of the forces on each body
        std::vector<Edge> edges;
        std::size_t order = 0; // of visits, from 1
        std::size_t low = 0;   // the earliest node that it or a node below it reaches on another path
        std::size_t next = 0;  // edge
        std::size_t by = none; // joint by which the walk reached it
        std::size_t from = none;
    };
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    [[nodiscard]] std::size_t nodeOf(SlotIndex slot) const {
        return slot == noSlot || bodies_[slot].fixed ? ground_ : slot;
    }

    void walk(std::size_t root) {
        finished_.clear();
        nodes_[root].order = nodes_[root].low = ++count_;
        for (std::size_t at = root;;) {
            Node& node = nodes_[at];
            if (node.next < node.edges.size()) {
                Edge const edge = node.edges[node.next++];
                Node& to = nodes_[edge.to];
                if (edge.joint == node.by || edge.to == at) {
                    continue;
                }
                if (to.order != 0) {
                    node.low = std::min(node.low, to.order);
                    continue;
                }
                to.order = to.low = ++count_;
                to.by = edge.joint;
                to.from = at;
                at = edge.to;
                continue;
            }
            if (at == root) {
                break;
            }
            finished_.push_back(at);
            Node& parent = nodes_[node.from];
            parent.low = std::min(parent.low, node.low);
            if (node.from != ground_) { // the ground does not add up the masses that it carries
                parent.mass += node.mass;
                parent.moment += node.moment;
                parent.force += node.force;
                parent.pulls += node.pulls;
            } else {
                setLoads(at, root);
            }
            at = node.from;
        }
        if (root != ground_) {
            setLoads(root, root);
        }
    }

    // All nodes that `top` joins are in `finished_`, children before their parents.
    void setLoads(std::size_t top, std::size_t root) {
        double const total = nodes_[top].mass;
        Vec2 const moment = nodes_[top].moment;
        Vec2 const force = nodes_[top].force;
        double const pulls = nodes_[top].pulls;
        for (std::size_t const at : finished_) {
            Node const& node = nodes_[at];
            bool const bridge = node.low == node.order;
            JointLoad load{total, pulls, {}, bridge};
            if (bridge) {
                bool const below = root == ground_ || 2 * node.mass <= total;
                load.mass = below ? node.mass : total - node.mass;
                load.pull = length(below ? node.force : force - node.force);
                Vec2 const share = below ? node.moment : moment - node.moment;
                load.centre = load.mass > 0 ? share / load.mass : Vec2{};
            }
            loads_[node.by] = load;
            for (Edge const& edge : node.edges) {
                if (loads_[edge.joint].mass == 0) { // a joint that closes a loop
                    loads_[edge.joint] = {total, pulls, {}, false};
                }
            }
        }
        finished_.clear();
    }

    BodyTable const& bodies_;
    std::vector<JointLoad> loads_;
    std::vector<Node> nodes_;
    std::vector<std::size_t> finished_;
    std::size_t ground_ = 0;
    std::size_t count_ = 0;
};

} // namespace

std::vector<JointLoad> jointLoads(DynamicsColumns const& columns, BodyTable const& bodies,
                                  JointTable const& joints, std::span<LoadSum const> loads) {
    return Walk(columns, bodies, joints, loads).run();
}

} // namespace trembler
