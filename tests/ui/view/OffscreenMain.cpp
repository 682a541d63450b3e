#include <gtest/gtest.h>

#include "app/offscreen/OffscreenApplication.h"

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    vestige::OffscreenApplication application;
    return RUN_ALL_TESTS();
}
