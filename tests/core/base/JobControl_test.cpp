#include "core/base/JobControl.h"

#include <gtest/gtest.h>

#include <vector>

using namespace vestige;

TEST(JobControl, SubStepsMapIntoTheirShare) {
    std::vector<double> seen;
    const JobControl job([&](double fraction, std::string_view) { seen.push_back(fraction); }, {});
    job.sub(0.5, 1).sub(0, 0.5).progress(1);
    job.progress(2);
    EXPECT_EQ(seen, (std::vector<double>{0.75, 1}));
}

TEST(JobControl, CancelReachesCopiesAndSubSteps) {
    const JobControl job;
    const JobControl step = job.sub(0, 0.1);
    EXPECT_FALSE(step.cancelled());
    job.cancel();
    EXPECT_TRUE(step.cancelled());
    EXPECT_FALSE(JobControl().cancelled());
}
