#include "physics/dynamics/engines/substepped/joint_rows.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

constexpr double unbounded = 1e300;
constexpr double correctionShare = 0.6;  // share of a position error that is corrected in one substep
constexpr double fastestCorrection = 10; // m/s or rad/s
constexpr double shortest = 1e-9;        // m: a shorter distance has no direction

} // namespace

double JointRow::solve(double relative) {
    double const before = impulse;
    impulse = std::clamp(before + mass * (speed - softness * before - relative), low, high);
    return impulse - before;
}

double JointRow::solveCorrection(double relative) {
    double const before = push;
    push = std::clamp(before + stiff * (correction - relative), low, high);
    return push - before;
}

struct JointRows::Ends {
    JointPose a;
    JointPose b;
    Vec2 armA;
    Vec2 armB;
    Vec2 apart; // from b's anchor to a's
    Vec2 axis;
    Vec2 parting; // m/s, how `apart` changes
    Vec2 curving; // m/s², how `parting` changes if no body accelerates

    // How fast the length of `apart` changes its rate, if no body accelerates.
    [[nodiscard]] static double bendOfLength(Vec2 along, double size, Vec2 rate, Vec2 curve) {
        double const lengthening = dot(along, rate);
        return dot(along, curve) +
               (size > shortest ? (lengthSquared(rate) - lengthening * lengthening) / size : 0);
    }
};

JointRows::JointRows(JointSpec const& spec, JointRows const* first, JointRows const* second)
    : joint_(*spec.joint), anchors_(spec.anchors) {
    a_ = bodyOf(spec.a);
    if (joint_.form != JointForm::gear) {
        b_ = bodyOf(spec.b);
        return;
    }
    for (JointRows const* const one : {first, second}) {
        coupled_.push_back(*one);
        coupled_.back().a_ = bodyOf(one->slots_[static_cast<std::size_t>(one->a_)]);
        coupled_.back().b_ = bodyOf(one->slots_[static_cast<std::size_t>(one->b_)]);
    }
}

int JointRows::bodyOf(SlotIndex slot) {
    for (int i = 0; i < bodies_; ++i) {
        if (slots_[static_cast<std::size_t>(i)] == slot) {
            return i;
        }
    }
    slots_[static_cast<std::size_t>(bodies_)] = slot;
    return bodies_++;
}

std::array<double, 5> JointRows::impulses() const {
    std::array<double, 5> impulses{};
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        impulses[i] = rows_[i].impulse;
    }
    return impulses;
}

void JointRows::setImpulses(std::array<double, 5> const& impulses) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        rows_[i].impulse = impulses[i];
    }
}

bool JointRows::restless() const {
    bool const drives = joint_.form == JointForm::hinge || joint_.form == JointForm::slider ||
                        joint_.form == JointForm::wheel;
    return drives && joint_.motor && joint_.motorSpeed != 0 && joint_.motorStrength > 0;
}

JointRows::Ends JointRows::endsOf(std::span<JointPose const> poses) const {
    Ends ends;
    ends.a = poses[static_cast<std::size_t>(a_)];
    ends.b = poses[static_cast<std::size_t>(b_)];
    ends.armA = rotated(anchors_.onA, ends.a.angle);
    ends.armB = rotated(anchors_.onB, ends.b.angle);
    ends.apart = ends.a.centre + ends.armA - ends.b.centre - ends.armB;
    ends.axis = rotated(anchors_.axis, ends.b.angle);
    ends.parting = ends.a.velocity + ends.a.spin * perpendicular(ends.armA) - ends.b.velocity -
                   ends.b.spin * perpendicular(ends.armB);
    ends.curving = ends.b.spin * ends.b.spin * ends.armB - ends.a.spin * ends.a.spin * ends.armA;
    return ends;
}

JointRows::Coordinate JointRows::turn(Ends const& ends) const {
    return {ends.a.angle - ends.b.angle - anchors_.referenceAngle, {{{a_, {}, 1}, {b_, {}, -1}}}};
}

// The displacement along a direction that rotates with b. As b's rotation turns the direction, b's arm
// reaches to the anchor of a.
JointRows::Coordinate JointRows::shift(Ends const& ends, Vec2 direction) const {
    double const spin = ends.b.spin;
    return {dot(direction, ends.apart),
            {{{a_, direction, cross(ends.armA, direction)},
              {b_, -direction, -cross(ends.apart + ends.armB, direction)}}},
            dot(direction, ends.curving) + 2 * spin * dot(perpendicular(direction), ends.parting) -
                spin * spin * dot(direction, ends.apart)};
}

JointRows::Coordinate JointRows::distance(Ends const& ends) const {
    double const size = length(ends.apart);
    Vec2 const direction = size > shortest ? ends.apart / size : Vec2{1, 0};
    return {size,
            {{{a_, direction, cross(ends.armA, direction)}, {b_, -direction, -cross(ends.armB, direction)}}},
            Ends::bendOfLength(direction, size, ends.parting, ends.curving)};
}

JointRows::Coordinate JointRows::coordinate(std::span<JointPose const> poses) const {
    Ends const ends = endsOf(poses);
    return joint_.form == JointForm::hinge ? turn(ends) : shift(ends, ends.axis);
}

JointRow& JointRows::row(Coordinate const& along, double scale) {
    JointRow& made = rows_[static_cast<std::size_t>(count_++)];
    double const kept = made.impulse;
    made = {};
    made.impulse = kept;
    made.count = 2;
    for (std::size_t i = 0; i < 2; ++i) {
        RowTerm const& term = along.terms[i];
        made.terms[i] = {term.body, scale * term.linear, scale * term.angular};
    }
    made.low = -unbounded;
    made.high = unbounded;
    made.bend = scale * along.bend;
    return made;
}

void JointRows::rigid(Coordinate const& along, double error) {
    JointRow& made = row(along);
    made.corrects = true;
    made.error = error;
    made.correction = std::clamp(-correctionShare * error / h_, -fastestCorrection, fastestCorrection);
}

void JointRows::pin(Ends const& ends) {
    for (Vec2 const direction : {Vec2{1, 0}, Vec2{0, 1}}) {
        Coordinate along = shift(ends, direction);
        // The direction is fixed in the world, so no body rotates it.
        along.terms[1].angular = -cross(ends.armB, direction);
        along.bend = dot(direction, ends.curving);
        rigid(along, along.value);
    }
}

void JointRows::drive(Coordinate const& along) {
    if (joint_.motor) {
        JointRow& motor = row(along);
        motor.speed = joint_.motorSpeed;
        motor.high = joint_.motorStrength * h_;
        motor.low = -motor.high;
    }
}

void JointRows::limit(Coordinate const& along) {
    if (!joint_.limited) {
        return;
    }
    // Inside the limit: the body may move at most to the limit within this substep. Outside: back to it, not
    // farther.
    auto const side = [&](double inside, double sign) {
        JointRow& stop = row(along, sign);
        stop.low = 0;
        stop.error = inside;
        stop.speed = -std::max(inside, 0.0) / h_;
        stop.corrects = inside < 0;
        stop.correction = std::min(-correctionShare * std::min(inside, 0.0) / h_, fastestCorrection);
    };
    side(along.value - joint_.lower, 1);
    side(joint_.upper - along.value, -1);
}

void JointRows::spring(Coordinate const& along, double error, std::span<JointPose const> poses) {
    JointRow& made = row(along);
    double inverse = 0;
    for (RowTerm const& term : along.terms) {
        JointPose const& pose = poses[static_cast<std::size_t>(term.body)];
        inverse +=
            pose.inverseMass * lengthSquared(term.linear) + pose.inverseInertia * term.angular * term.angular;
    }
    if (h_ * std::sqrt(joint_.stiffness * inverse) <= widestSwing_) {
        made.pull = -joint_.stiffness * error;
        made.damping = joint_.dampingRate;
        made.softness = joint_.dampingRate > 0 ? 1 / (h_ * joint_.dampingRate) : unbounded;
        return;
    }
    double const resistance = h_ * (joint_.dampingRate + h_ * joint_.stiffness);
    made.softness = resistance > 0 ? 1 / resistance : unbounded;
    made.speed = -error * h_ * joint_.stiffness * made.softness;
}

void JointRows::prepare(std::span<JointPose const> poses, double h, double widestSwing) {
    h_ = h;
    widestSwing_ = widestSwing;
    count_ = 0;
    Ends const ends = endsOf(poses);
    switch (joint_.form) {
    case JointForm::hinge:
        drive(turn(ends));
        limit(turn(ends));
        pin(ends);
        break;
    case JointForm::weld:
        rigid(turn(ends), turn(ends).value);
        pin(ends);
        break;
    case JointForm::slider: {
        Coordinate const along = shift(ends, ends.axis);
        Coordinate const across = shift(ends, perpendicular(ends.axis));
        drive(along);
        limit(along);
        rigid(turn(ends), turn(ends).value);
        rigid(across, across.value);
        break;
    }
    case JointForm::wheel: {
        Coordinate const along = shift(ends, ends.axis);
        Coordinate const across = shift(ends, perpendicular(ends.axis));
        drive(turn(ends));
        spring(along, along.value, poses);
        limit(along);
        rigid(across, across.value);
        break;
    }
    case JointForm::distance: {
        Coordinate const along = distance(ends);
        rigid(along, along.value - anchors_.length);
        break;
    }
    case JointForm::rope: {
        Coordinate const along = distance(ends);
        taut(along, anchors_.length - along.value);
        break;
    }
    case JointForm::spring: {
        Coordinate const along = distance(ends);
        spring(along, along.value - anchors_.length, poses);
        break;
    }
    case JointForm::pulley:
        preparePulley(ends);
        break;
    case JointForm::gear:
        prepareGear(poses);
        break;
    }
    for (JointRow& made : rows()) {
        double inverse = 0;
        for (int i = 0; i < made.count; ++i) {
            RowTerm const& term = made.terms[static_cast<std::size_t>(i)];
            JointPose const& pose = poses[static_cast<std::size_t>(term.body)];
            inverse += pose.inverseMass * lengthSquared(term.linear) +
                       pose.inverseInertia * term.angular * term.angular;
        }
        made.stiff = inverse > 0 ? 1 / inverse : 0;
        made.mass = inverse > 0 ? 1 / (inverse + made.softness) : 0;
    }
    for (std::size_t i = static_cast<std::size_t>(count_); i < rows_.size(); ++i) {
        rows_[i].impulse = 0;
    }
}

// A rope pulls and never pushes: at most it becomes taut within this substep.
void JointRows::taut(Coordinate const& along, double slack) {
    JointRow& made = row(along, -1);
    made.low = 0;
    made.error = slack;
    made.speed = -std::max(slack, 0.0) / h_;
    made.corrects = slack < 0;
    made.correction = std::min(-correctionShare * std::min(slack, 0.0) / h_, fastestCorrection);
}

void JointRows::preparePulley(Ends const& ends) {
    Vec2 const ropeA = ends.a.centre + ends.armA - joint_.groundA;
    Vec2 const ropeB = ends.b.centre + ends.armB - joint_.groundB;
    double const sizeA = length(ropeA);
    double const sizeB = length(ropeB);
    Vec2 const alongA = sizeA > shortest ? ropeA / sizeA : Vec2{0, -1};
    Vec2 const unitB = sizeB > shortest ? ropeB / sizeB : Vec2{0, -1};
    Vec2 const alongB = joint_.ratio * unitB;
    auto const bend = [](JointPose const& pose, Vec2 arm, Vec2 along, double size) {
        return Ends::bendOfLength(along, size, pose.velocity + pose.spin * perpendicular(arm),
                                  -pose.spin * pose.spin * arm);
    };
    Coordinate const sum{sizeA + joint_.ratio * sizeB,
                         {{{a_, alongA, cross(ends.armA, alongA)}, {b_, alongB, cross(ends.armB, alongB)}}},
                         bend(ends.a, ends.armA, alongA, sizeA) +
                             joint_.ratio * bend(ends.b, ends.armB, unitB, sizeB)};
    taut(sum, anchors_.length + joint_.ratio * anchors_.lengthB - sum.value);
}

void JointRows::prepareGear(std::span<JointPose const> poses) {
    Coordinate const first = coupled_[0].coordinate(poses);
    Coordinate const second = coupled_[1].coordinate(poses);
    double const sum = first.value + joint_.ratio * second.value;
    if (!constant_) {
        constant_ = sum;
    }
    rigid(first, sum - *constant_);
    JointRow& both = rows_[0];
    both.bend += joint_.ratio * second.bend;
    for (RowTerm const& term : second.terms) {
        auto const end = both.terms.begin() + both.count;
        auto at =
            std::find_if(both.terms.begin(), end, [&](RowTerm const& t) { return t.body == term.body; });
        if (at == end) {
            *at = {term.body, {}, 0};
            ++both.count;
        }
        at->linear += joint_.ratio * term.linear;
        at->angular += joint_.ratio * term.angular;
    }
}

Vec2 JointRows::impulseOnA(double h) const {
    Vec2 sum;
    for (int i = 0; i < count_; ++i) {
        JointRow const& one = rows_[static_cast<std::size_t>(i)];
        for (int n = 0; n < one.count; ++n) {
            RowTerm const& term = one.terms[static_cast<std::size_t>(n)];
            if (term.body == a_) {
                sum += (one.impulse + h * one.pull) * term.linear;
            }
        }
    }
    return sum;
}

} // namespace trembler
