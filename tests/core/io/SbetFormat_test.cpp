#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/Units.h"
#include "tests/core/io/Clouds.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

/// Time, latitude, longitude (degrees), height; the other 13 doubles of a record are velocities and angles.
std::string record(double time, double latitude, double longitude, double height) {
    double values[17] = {time, radians(latitude), radians(longitude), height};
    for (int i = 4; i < 17; ++i) values[i] = 0.01 * i;
    return {reinterpret_cast<const char*>(values), sizeof values};
}

/// Easting and northing by Krueger's series in n to the fourth order (Karney 2011, eq. 7-11 and 35), good to
/// a micrometre in a zone: written out here, not GeographicLib.
Eigen::Vector2d utm(double latitude_deg, double fromMeridian_deg) {
    const double f = 1 / 298.257223563, a = 6378137, n = f / (2 - f);
    const double e = std::sqrt(f * (2 - f));
    const double radius = a / (1 + n) * (1 + n * n / 4 + std::pow(n, 4) / 64);
    const double alpha[4] = {n / 2 - 2 * n * n / 3 + 5 * std::pow(n, 3) / 16 + 41 * std::pow(n, 4) / 180,
                             13 * n * n / 48 - 3 * std::pow(n, 3) / 5 + 557 * std::pow(n, 4) / 1440,
                             61 * std::pow(n, 3) / 240 - 103 * std::pow(n, 4) / 140,
                             49561 * std::pow(n, 4) / 161280};
    const double phi = radians(latitude_deg), lambda = radians(fromMeridian_deg);
    const double tau = std::tan(phi);
    const double sigma = std::sinh(e * std::atanh(e * tau / std::sqrt(1 + tau * tau)));
    const double conformal = tau * std::sqrt(1 + sigma * sigma) - sigma * std::sqrt(1 + tau * tau);
    const double xi = std::atan2(conformal, std::cos(lambda));
    const double eta = std::asinh(std::sin(lambda) / std::hypot(conformal, std::cos(lambda)));
    double north = xi, east = eta;
    for (int j = 1; j <= 4; ++j) {
        north += alpha[j - 1] * std::sin(2 * j * xi) * std::cosh(2 * j * eta);
        east += alpha[j - 1] * std::cos(2 * j * xi) * std::sinh(2 * j * eta);
    }
    return {500000 + 0.9996 * radius * east, 0.9996 * radius * north};
}

std::string refusal(const std::filesystem::path& file, const std::string& content) {
    writeBytes(file, content);
    const Result<LoadedGeometry> loaded = readGeometry(file);
    if (loaded) return "read";
    EXPECT_EQ(loaded.error().code, ErrorCode::input);
    return loaded.error().sentence();
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST(SbetFormat, GivesThePositionsInUtmOfTheFirstZone) {
    const TemporaryFolder folder;
    const auto file = folder / "flight_sbet.out";
    // Zone 32 has its meridian at 9 degrees; the last record lies over its border.
    const double places[][2] = {{52.5, 11.5}, {52.52, 11.9}, {48.001, 8.2}, {52.6, 12.3}};
    std::string content;
    for (int i = 0; i < 4; ++i) content += record(300000 + 0.005 * i, places[i][0], places[i][1], 100 + i);
    writeBytes(file, content);
    const LoadedGeometry flight = readOrFail(file);
    ASSERT_EQ(flight.geometry.vertices.size(), 4);
    for (std::size_t i = 0; i < 4; ++i) {
        const Eigen::Vector2d expected = utm(places[i][0], places[i][1] - 9);
        EXPECT_LT((flight.geometry.vertices.point(i).head<2>() - expected).norm(), 1e-4) << i;
        EXPECT_NEAR(flight.geometry.vertices.point(i).z(), 100 + static_cast<double>(i), 1e-9);
        EXPECT_EQ(flight.geometry.vertices.attributes().gpsTime[i], 300000 + 0.005 * static_cast<double>(i));
    }
    EXPECT_NE(flight.info.crs.find("WGS 84 / UTM zone 32N"), std::string::npos);
    EXPECT_NE(flight.info.crs.find("32632"), std::string::npos);
    EXPECT_NE(flight.info.version.find("heights above the ellipsoid"), std::string::npos);
    EXPECT_NE(flight.info.version.find("longitude 8.200000 to 12.300000"), std::string::npos)
        << flight.info.version;
    ASSERT_TRUE(flight.info.timeSpan);
    EXPECT_EQ(flight.info.timeSpan->second, 300000 + 0.015);
    ASSERT_EQ(flight.info.warnings.size(), 1);
    EXPECT_NE(flight.info.warnings[0].find("attitude"), std::string::npos);
    // The reference system goes with the points into LAS.
    ASSERT_TRUE(writeGeometry(folder / "flight.las", flight.geometry, {&flight.info}));
    EXPECT_EQ(readOrFail(folder / "flight.las").info.crs, flight.info.crs);
}

TEST(SbetFormat, KnowsTheSouthAndTheDateLine) {
    const TemporaryFolder folder;
    // Suva, zone 60; the flight crosses to 180 degrees west.
    writeBytes(folder / "a.sbet", record(1, -18.1, 179.99, 5) + record(2, -18.1, -179.99, 5));
    const LoadedGeometry flight = readOrFail(folder / "a.sbet");
    EXPECT_NE(flight.info.crs.find("UTM zone 60S"), std::string::npos);
    const Eigen::Vector2d first = utm(-18.1, 2.99) + Eigen::Vector2d(0, 1e7);
    EXPECT_LT((flight.geometry.vertices.point(0).head<2>() - first).norm(), 1e-4);
    EXPECT_NEAR((flight.geometry.vertices.point(1) - flight.geometry.vertices.point(0)).norm(),
                radians(0.02) * 6378137 * std::cos(radians(18.1)), 5);
}

TEST(SbetFormat, TellsAtOnceWhatItHolds) {
    const TemporaryFolder folder;
    std::string content;
    for (int i = 0; i < 1000; ++i) content += record(300000 + i, 52.5, 11.5 + 1e-5 * i, 100);
    writeBytes(folder / "a.sbet", content);
    const Result<FileInfo> peeked = peekFile(folder / "a.sbet");
    ASSERT_TRUE(peeked);
    EXPECT_EQ(peeked->points, 1000);
    EXPECT_EQ(peeked->timeSpan->second, 300999);
    EXPECT_EQ(peeked->metresPerUnit, 1);
}

TEST(SbetFormat, RefusesWhatIsNoTrajectory) {
    const TemporaryFolder folder;
    const auto file = folder / "a.sbet";
    const std::string good = record(1, 52, 11, 100);
    EXPECT_NE(refusal(file, good + record(2, kNan, 11, 100)).find("byte 136"), std::string::npos);
    EXPECT_NE(refusal(file, good + record(2, 52, kNan, 100)).find("longitude"), std::string::npos);
    EXPECT_NE(refusal(file, good + record(kNan, 52, 11, 100)).find("time"), std::string::npos);
    EXPECT_NE(refusal(file, good + record(2, 90.1, 11, 100)).find("pole"), std::string::npos);
    EXPECT_NE(refusal(file, good + record(2, 52, 11, HUGE_VAL)).find("height"), std::string::npos);
    EXPECT_NE(refusal(file, good + record(2, 52, 80, 100)).find("far from the zone"), std::string::npos);
    EXPECT_NE(refusal(file, good + good.substr(0, 135)).find("inside a record"), std::string::npos);
    EXPECT_NE(refusal(file, good.substr(0, 100)).find("first record"), std::string::npos);
    EXPECT_NE(refusal(folder / "a.out", std::string(272, 'x')), "read");
    EXPECT_NE(refusal(folder / "b.out", "1 2 3\n4 5 6\n"), "read");
}

TEST(SbetFormat, SaysThatTimeGoesBackAndSalvages) {
    const TemporaryFolder folder;
    const auto file = folder / "a.sbet";
    const std::string content = record(5, 52, 11, 100) + record(4, 52, 11, 100) + record(6, 52, 11, 100);
    writeBytes(file, content);
    EXPECT_NE(readOrFail(file).info.warnings[0].find("goes back at 1 record"), std::string::npos);
    ReadOptions salvage;
    salvage.salvage = true;
    writeBytes(file, content + "tail");
    const Result<LoadedGeometry> cut = readGeometry(file, salvage);
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut->geometry.vertices.size(), 3);
    EXPECT_NE(cut->info.damage.find("the first 3 of 4 records"), std::string::npos);
    writeBytes(file, content + record(7, 95, 11, 100) + content);
    const Result<LoadedGeometry> broken = readGeometry(file, salvage);
    ASSERT_TRUE(broken);
    EXPECT_EQ(broken->geometry.vertices.size(), 3);
    EXPECT_FALSE(broken->info.damage.empty());
}
