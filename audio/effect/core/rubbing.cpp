#include "audio/effect/core/rubbing.hpp"

namespace trembler {

double rubbingSpeed(double slip, double rolling) {
    double const speed = slip > slowestRubbing ? slip : rolling;
    return speed > slowestRubbing ? speed : 0;
}

double rubbingForce(double load, double slip, double friction) {
    return slip > slowestRubbing ? slidingShare * friction * load : rollingShare * load;
}

} // namespace trembler
