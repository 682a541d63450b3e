#include "core/survey/CircularFlight.h"

#include <gtest/gtest.h>

#include "core/survey/Sensors.h"

namespace vestige {
namespace {

TEST(CircularFlight, KeepsTheBoresightOnTheTarget) {
    CircularFlight flight;
    flight.target = {3, -2, 0.5};
    flight.radius_m = 12;
    for (const double t : {0.0, 7.3, 21.0, 39.9}) {
        const Pose pose = flight.siteFromSensor(t);
        const Eigen::Vector3d towards = (flight.target - pose.translation()).normalized();
        EXPECT_LT((pose.linear().col(0) - towards).norm(), 1e-12);
        EXPECT_NEAR(pose.linear().determinant(), 1, 1e-12);
        EXPECT_NEAR(pose.translation().z(), 15.5, 1e-12);
        EXPECT_NEAR((pose.translation() - flight.target).head<2>().norm(), 12, 1e-12);
        EXPECT_GT(pose.linear()(2, 2), 0);
    }
    EXPECT_LT((flight.siteFromSensor(40).matrix() - flight.siteFromSensor(0).matrix()).norm(), 1e-12);
}

TEST(Sensors, HaveTheSheetsFootprint) {
    // METHOD section 1: 73 x 8 mm at 15 m.
    EXPECT_NEAR(15 * zenmuseL1().divergenceLong_rad, 0.073, 0.001);
    EXPECT_NEAR(15 * zenmuseL1().divergenceShort_rad, 0.008, 0.001);
}

}  // namespace
}  // namespace vestige
