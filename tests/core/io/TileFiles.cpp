#include "tests/core/io/TileFiles.h"

#include <cmath>
#include <cstdint>

#include "core/base/Numbers.h"

namespace vestige::test {

std::string pntsBytes(std::string featureJson, std::string featureBinary, std::string batchJson,
                      std::string batchBinary) {
    const auto padTo = [](std::string& text, std::size_t before, char with) {
        while ((before + text.size()) % 8 != 0) text += with;
    };
    padTo(featureJson, 28, ' ');
    padTo(featureBinary, 0, '\0');
    padTo(batchJson, 0, ' ');
    padTo(batchBinary, 0, '\0');
    const auto size = [](const std::string& text) { return static_cast<std::uint32_t>(text.size()); };
    return "pnts" +
           bytesOf<std::uint32_t>(
               {1, 28 + size(featureJson) + size(featureBinary) + size(batchJson) + size(batchBinary),
                size(featureJson), size(featureBinary), size(batchJson), size(batchBinary)}) +
           featureJson + featureBinary + batchJson + batchBinary;
}

std::string pntsOf(const std::vector<Eigen::Vector3f>& points) {
    std::vector<float> numbers;
    for (const Eigen::Vector3f& point : points)
        numbers.insert(numbers.end(), {point.x(), point.y(), point.z()});
    return pntsBytes(R"({"POSITION":{"byteOffset":0},"POINTS_LENGTH":)" + std::to_string(points.size()) + "}",
                     bytesOf(numbers));
}

std::string tilesetJson(const std::string& root) {
    return R"({"asset":{"version":"1.0"},"geometricError":100,"root":{)" + root + "}}";
}

std::string transformJson(const Eigen::Matrix4d& matrix) {
    std::string text;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) text += (text.empty() ? "" : ",") + exactText(matrix(row, column));
    return "\"transform\":[" + text + "]";
}

Eigen::Vector3d earthCentred(double longitude_deg, double latitude_deg, double height_m) {
    const double a = 6378137, f = 1 / 298.257223563, e2 = f * (2 - f), deg = std::acos(-1.0) / 180;
    const double lambda = longitude_deg * deg, phi = latitude_deg * deg;
    const double n = a / std::sqrt(1 - e2 * std::sin(phi) * std::sin(phi));
    return {(n + height_m) * std::cos(phi) * std::cos(lambda),
            (n + height_m) * std::cos(phi) * std::sin(lambda), (n * (1 - e2) + height_m) * std::sin(phi)};
}

Eigen::Matrix4d eastNorthUp(double longitude_deg, double latitude_deg, double height_m) {
    const double deg = std::acos(-1.0) / 180;
    const double lambda = longitude_deg * deg, phi = latitude_deg * deg;
    Eigen::Matrix4d frame = Eigen::Matrix4d::Identity();
    frame.block<3, 1>(0, 0) << -std::sin(lambda), std::cos(lambda), 0;
    frame.block<3, 1>(0, 1) << -std::sin(phi) * std::cos(lambda), -std::sin(phi) * std::sin(lambda),
        std::cos(phi);
    frame.block<3, 1>(0, 2) << std::cos(phi) * std::cos(lambda), std::cos(phi) * std::sin(lambda),
        std::sin(phi);
    frame.block<3, 1>(0, 3) = earthCentred(longitude_deg, latitude_deg, height_m);
    return frame;
}

}  // namespace vestige::test
