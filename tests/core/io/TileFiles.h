#pragma once

#include <Eigen/Core>
#include <cstring>
#include <initializer_list>
#include <string>
#include <vector>

namespace vestige::test {

/// The bytes of numbers, one after the other (the tests run on little endian machines).
template <class Number>
std::string bytesOf(const std::vector<Number>& numbers) {
    std::string bytes(numbers.size() * sizeof(Number), '\0');
    if (!numbers.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
    return bytes;
}
template <class Number>
std::string bytesOf(std::initializer_list<Number> numbers) {
    return bytesOf(std::vector<Number>(numbers));
}

/// A point tile of 3D Tiles 1.0, written by its specification.
std::string pntsBytes(std::string featureJson, std::string featureBinary, std::string batchJson = {},
                      std::string batchBinary = {});

/// A point tile with these points and nothing else.
std::string pntsOf(const std::vector<Eigen::Vector3f>& points);

/// The tileset.json round a root tile; `root` is the inside of its object.
std::string tilesetJson(const std::string& root);
/// "\"transform\":[...]" of a matrix, exact.
std::string transformJson(const Eigen::Matrix4d& matrix);

/// Earth-centred coordinates (WGS 84) of a place; degrees and metres. Closed formula (EPSG method 9602).
Eigen::Vector3d earthCentred(double longitude_deg, double latitude_deg, double height_m);
/// The frame of east, north and up there, in Earth-centred coordinates.
Eigen::Matrix4d eastNorthUp(double longitude_deg, double latitude_deg, double height_m);

}  // namespace vestige::test
