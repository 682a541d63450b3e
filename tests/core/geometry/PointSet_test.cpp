#include "core/geometry/PointSet.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <set>

namespace vestige {
namespace {

using Indices = std::vector<std::uint32_t>;

Indices randomIndices(std::mt19937& random, double share) {
    Indices indices;
    std::bernoulli_distribution taken(share);
    for (std::uint32_t i = 0; i < 500; ++i)
        if (taken(random)) indices.push_back(i);
    return indices;
}

TEST(PointSet, ActsAsASetOfIndices) {
    std::mt19937 random(7);
    for (int round = 0; round < 50; ++round) {
        const Indices a = randomIndices(random, 0.02 * (round % 48 + 1));
        const Indices b = randomIndices(random, 0.5);
        const PointSet setA = PointSet::fromSorted(a);
        const PointSet setB = PointSet::fromSorted(b);
        EXPECT_EQ(setA.indices(), a);
        EXPECT_EQ(setA.size(), a.size());
        Indices all(500);
        std::iota(all.begin(), all.end(), 0u);
        Indices united, less, rest;
        std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(united));
        std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(less));
        std::set_difference(all.begin(), all.end(), a.begin(), a.end(), std::back_inserter(rest));
        EXPECT_EQ(setA.unitedWith(setB), PointSet::fromSorted(united));
        EXPECT_EQ(setA.without(setB), PointSet::fromSorted(less));
        EXPECT_EQ(setA.complement(500), PointSet::fromSorted(rest));
        for (std::uint32_t i = 0; i < 502; ++i)
            EXPECT_EQ(setA.contains(i), std::binary_search(a.begin(), a.end(), i));
    }
}

TEST(PointSet, HoldsNeighboursAsOneRun) {
    EXPECT_EQ(PointSet::fromSorted(Indices{3, 4, 5, 9}).runs().size(), 2u);
    EXPECT_TRUE(PointSet().empty());
    EXPECT_TRUE(PointSet().complement(0).empty());
}

}  // namespace
}  // namespace vestige
