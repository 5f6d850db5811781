#include "physics/dynamics/engines/box2d/joints_at_once.hpp"

// Only the parts of Eigen under the Mozilla Public License; and no vectorisation, so that the order of
// arithmetic is the same with every compiler.
#define EIGEN_MPL2_ONLY
#define EIGEN_DONT_VECTORIZE
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <map>

namespace trembler {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

constexpr double regularisation = 1e-12;
// Entries of the factor per equation: a chain or a tree has about four, a net many more.
constexpr Eigen::Index densest = 40;

std::size_t rowsOf(b2Joint& joint) {
    switch (joint.GetType()) {
    case e_revoluteJoint:
        return 2;
    case e_weldJoint:
        return static_cast<b2WeldJoint&>(joint).GetStiffness() > 0 ? 2 : 3;
    case e_distanceJoint: {
        auto const& distance = static_cast<b2DistanceJoint const&>(joint);
        return distance.GetMinLength() == distance.GetMaxLength() && distance.GetStiffness() == 0 ? 1 : 0;
    }
    default:
        return 0;
    }
}

double cross(b2Vec2 arm, double nx, double ny) {
    return static_cast<double>(arm.x) * ny - static_cast<double>(arm.y) * nx;
}

using Order = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

// Whether the factor of a matrix, given by its lower triangle, would have more than `most` entries outside
// its diagonal. Walks the elimination tree (Liu 1990) as the factorisation would, and stops as soon as the
// answer is known; needs memory for the matrix only.
bool factorExceeds(Matrix const& lower, Order const& order, Eigen::Index most) {
    Matrix upper(lower.rows(), lower.cols());
    upper.selfadjointView<Eigen::Upper>() = lower.selfadjointView<Eigen::Lower>().twistedBy(order);
    constexpr Eigen::Index none = -1;
    std::vector<Eigen::Index> parent(static_cast<std::size_t>(lower.cols()), none);
    std::vector<Eigen::Index> seen(static_cast<std::size_t>(lower.cols()), none);
    Eigen::Index entries = 0;
    for (Eigen::Index column = 0; column < upper.cols(); ++column) {
        seen[static_cast<std::size_t>(column)] = column;
        for (Matrix::InnerIterator entry(upper, column); entry; ++entry) {
            for (Eigen::Index row = entry.row();
                 row < column && seen[static_cast<std::size_t>(row)] != column;) {
                if (++entries > most) {
                    return true;
                }
                seen[static_cast<std::size_t>(row)] = column;
                Eigen::Index& up = parent[static_cast<std::size_t>(row)];
                up = up == none ? column : up;
                row = up;
            }
        }
    }
    return false;
}

} // namespace

struct JointsAtOnce::Factor {
    Matrix matrix; // the lower triangle
    Eigen::SimplicialLDLT<Matrix, Eigen::Lower> ldlt;
    // Index of the matrix entry for each pair of rows of each mover, in order.
    std::vector<std::size_t> entries;
    std::vector<std::size_t> diagonal; // index of the diagonal entry, by row
    Vector right;
    Vector found;
};

JointsAtOnce::JointsAtOnce() : factor_(std::make_unique<Factor>()) {}
JointsAtOnce::~JointsAtOnce() = default;

void JointsAtOnce::setJoints(std::span<b2Joint* const> joints) {
    movers_.clear();
    ties_.clear();
    rows_.clear();
    impulses_.assign(joints.size(), b2Vec2_zero);
    std::map<std::uintptr_t, std::size_t> known; // movers by the slot of their body, which is its user data
    auto const moverOf = [&](b2Body* body) {
        if (body->GetType() != b2_dynamicBody) {
            return none;
        }
        auto const [at, isNew] = known.emplace(body->GetUserData().pointer, movers_.size());
        if (isNew) {
            movers_.emplace_back().body = body;
        }
        return at->second;
    };
    for (std::size_t slot = 0; slot < joints.size(); ++slot) {
        b2Joint* const joint = joints[slot];
        std::size_t const count = joint == nullptr ? 0 : rowsOf(*joint);
        if (count == 0) {
            continue;
        }
        Tie const tie{.joint = joint,
                      .slot = static_cast<SlotIndex>(slot),
                      .a = moverOf(joint->GetBodyA()),
                      .b = moverOf(joint->GetBodyB()),
                      .firstRow = rows_.size(),
                      .rows = count};
        for (std::size_t row = rows_.size(); row < rows_.size() + count; ++row) {
            if (tie.a != none) {
                movers_[tie.a].rows.emplace_back(row, -1.0);
            }
            if (tie.b != none) {
                movers_[tie.b].rows.emplace_back(row, 1.0);
            }
        }
        rows_.resize(rows_.size() + count);
        ties_.push_back(tie);
    }
    findStructure();
}

void JointsAtOnce::findStructure() {
    Factor& factor = *factor_;
    auto const size = static_cast<Eigen::Index>(rows_.size());
    tooDense_ = size == 0 || pairsExceed(2 * static_cast<std::size_t>(densest + 1) * rows_.size());
    if (tooDense_) { // even the matrix would need too much memory
        return;
    }
    std::vector<Eigen::Triplet<double>> all;
    for (Mover const& mover : movers_) {
        for (auto const& [i, si] : mover.rows) {
            for (auto const& [j, sj] : mover.rows) {
                if (j <= i) {
                    all.emplace_back(static_cast<int>(i), static_cast<int>(j), 1.0);
                }
            }
        }
    }
    factor.matrix.resize(size, size);
    factor.matrix.setFromTriplets(all.begin(), all.end());
    Order inverse;
    Eigen::AMDOrdering<int>()(factor.matrix.selfadjointView<Eigen::Lower>(), inverse);
    tooDense_ = factorExceeds(factor.matrix, inverse.inverse(), densest * size);
    if (tooDense_) {
        return;
    }
    auto const entry = [&](std::size_t i, std::size_t j) {
        double const* const at =
            &factor.matrix.coeffRef(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
        return static_cast<std::size_t>(at - factor.matrix.valuePtr());
    };
    factor.entries.clear();
    for (Mover const& mover : movers_) {
        for (auto const& [i, si] : mover.rows) {
            for (auto const& [j, sj] : mover.rows) {
                if (j <= i) {
                    factor.entries.push_back(entry(i, j));
                }
            }
        }
    }
    factor.diagonal.clear();
    for (std::size_t row = 0; row < rows_.size(); ++row) {
        factor.diagonal.push_back(entry(row, row));
    }
    factor.right.resize(size);
    factor.ldlt.analyzePattern(factor.matrix);
}

// Every pair of rows that share a body is an entry of the matrix, and two rows share at most two bodies. So
// with more than twice as many pairs as the factor may have entries, it is too dense in any order.
bool JointsAtOnce::pairsExceed(std::size_t most) const {
    std::size_t pairs = 0;
    for (Mover const& mover : movers_) {
        pairs += mover.rows.size() * (mover.rows.size() + 1) / 2;
        if (pairs > most) {
            return true;
        }
    }
    return false;
}

void JointsAtOnce::look(float h, std::function<Pull(b2Body const&)> const& pullOn) {
    auto const step = static_cast<double>(h);
    for (Mover& mover : movers_) {
        b2Body const& body = *mover.body;
        double const linear = 1 / (1 + step * static_cast<double>(body.GetLinearDamping()));
        double const angular = 1 / (1 + step * static_cast<double>(body.GetAngularDamping()));
        double const perMass = 1 / static_cast<double>(body.GetMass());
        double const perInertia = 1 / static_cast<double>(body.GetInertia());
        Pull const pull = body.IsAwake() ? pullOn(body) : Pull{b2Vec2_zero, 0};
        b2Vec2 const v = body.GetLinearVelocity();
        mover.vx = linear * (static_cast<double>(v.x) + step * perMass * static_cast<double>(pull.force.x));
        mover.vy = linear * (static_cast<double>(v.y) + step * perMass * static_cast<double>(pull.force.y));
        mover.spin = angular * (static_cast<double>(body.GetAngularVelocity()) +
                                step * perInertia * static_cast<double>(pull.torque));
        mover.inverseMass = linear * perMass;
        mover.inverseInertia = angular * perInertia;
        mover.px = mover.py = mover.turn = 0;
    }
    for (Tie const& tie : ties_) {
        setRows(tie);
    }
}

void JointsAtOnce::setRows(Tie const& tie) {
    b2Vec2 const onA = tie.joint->GetAnchorA();
    b2Vec2 const onB = tie.joint->GetAnchorB();
    b2Vec2 const armA = onA - tie.joint->GetBodyA()->GetWorldCenter();
    b2Vec2 const armB = onB - tie.joint->GetBodyB()->GetWorldCenter();
    auto const along = [&](double nx, double ny) {
        return Row{nx, ny, cross(armA, nx, ny), cross(armB, nx, ny)};
    };
    Row* const rows = &rows_[tie.firstRow];
    if (tie.rows == 1) {
        double const dx = static_cast<double>(onB.x) - static_cast<double>(onA.x);
        double const dy = static_cast<double>(onB.y) - static_cast<double>(onA.y);
        double const distance = std::hypot(dx, dy);
        rows[0] = distance > 0 ? along(dx / distance, dy / distance) : along(1, 0);
        return;
    }
    rows[0] = along(1, 0);
    rows[1] = along(0, 1);
    if (tie.rows == 3) {
        rows[2] = {0, 0, 1, 1};
    }
}

bool JointsAtOnce::factorise() {
    Factor& factor = *factor_;
    double* const values = factor.matrix.valuePtr();
    std::fill(values, values + factor.matrix.nonZeros(), 0.0);
    std::size_t next = 0;
    for (Mover const& mover : movers_) {
        for (auto const& [i, si] : mover.rows) {
            Row const& x = rows_[i];
            double const tx = si < 0 ? x.ta : x.tb;
            for (auto const& [j, sj] : mover.rows) {
                if (j <= i) {
                    Row const& y = rows_[j];
                    double const ty = sj < 0 ? y.ta : y.tb;
                    values[factor.entries[next++]] +=
                        si * sj *
                        (mover.inverseMass * (x.nx * y.nx + x.ny * y.ny) + mover.inverseInertia * tx * ty);
                }
            }
        }
    }
    for (std::size_t const at : factor.diagonal) {
        values[at] *= 1 + regularisation;
    }
    factor.ldlt.factorize(factor.matrix);
    if (factor.ldlt.info() != Eigen::Success) {
        return false;
    }
    Vector& right = factor.right;
    for (Tie const& tie : ties_) {
        Mover const fixed{};
        Mover const& a = tie.a == none ? fixed : movers_[tie.a];
        Mover const& b = tie.b == none ? fixed : movers_[tie.b];
        for (std::size_t row = tie.firstRow; row < tie.firstRow + tie.rows; ++row) {
            Row const& r = rows_[row];
            right[static_cast<Eigen::Index>(row)] =
                -(r.nx * (b.vx - a.vx) + r.ny * (b.vy - a.vy) + r.tb * b.spin - r.ta * a.spin);
        }
    }
    factor.found = factor.ldlt.solve(right);
    return factor.found.allFinite();
}

void JointsAtOnce::give() {
    for (Tie const& tie : ties_) {
        double px = 0;
        double py = 0;
        double turnA = 0;
        double turnB = 0;
        for (std::size_t row = tie.firstRow; row < tie.firstRow + tie.rows; ++row) {
            double const size = factor_->found[static_cast<Eigen::Index>(row)];
            px += size * rows_[row].nx;
            py += size * rows_[row].ny;
            turnA += size * rows_[row].ta;
            turnB += size * rows_[row].tb;
        }
        impulses_[tie.slot] = {static_cast<float>(px), static_cast<float>(py)};
        if (tie.a != none) {
            Mover& a = movers_[tie.a];
            a.px -= px;
            a.py -= py;
            a.turn -= turnA;
        }
        if (tie.b != none) {
            Mover& b = movers_[tie.b];
            b.px += px;
            b.py += py;
            b.turn += turnB;
        }
    }
    for (Mover const& mover : movers_) {
        mover.body->ApplyLinearImpulseToCenter({static_cast<float>(mover.px), static_cast<float>(mover.py)},
                                               false);
        mover.body->ApplyAngularImpulse(static_cast<float>(mover.turn), false);
    }
}

void JointsAtOnce::solve(float h, std::function<Pull(b2Body const&)> const& pullOn) {
    if (tooDense_) {
        return;
    }
    look(h, pullOn);
    if (factorise()) {
        give();
    } else {
        std::fill(impulses_.begin(), impulses_.end(), b2Vec2_zero);
    }
}

} // namespace trembler
