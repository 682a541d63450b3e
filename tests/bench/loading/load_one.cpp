// Loads one file once and prints what it took: peer, seconds, points, peak of memory (all, and without the
// file's own pages).
//   load_one PEER FILE      PEER: ours, ours-all, preview, index, read, laszip
#include <fcntl.h>
#include <laszip/laszip_api.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "core/geometry/Octree.h"
#include "core/io/FormatRegistry.h"

namespace {

using namespace vestige;

[[noreturn]] void stop(const std::string& why) {
    std::cerr << why << "\n";
    std::exit(3);
}

std::uint64_t ours(const std::string& file, ReadOptions::Attributes attributes) {
    ReadOptions options;
    options.attributes = attributes;
    const auto loaded = readGeometry(file, options);
    if (!loaded) stop(loaded.error().sentence());
    return loaded->geometry.vertices.size();
}

std::uint64_t previewed(const std::string& file) {
    const auto format = formatOfFile(file);
    if (!format) stop(format.error().sentence());
    const auto shown = (*format)->preview(file, 1'500'000, {});
    if (!shown || !*shown) stop("no preview");
    const auto cloud = std::make_shared<const PointCloud>((*shown)->geometry.vertices);
    return Octree(cloud).order().size();
}

/// Everything the window needs to draw and pick.
std::uint64_t indexed(const std::string& file) {
    ReadOptions options;
    options.attributes = ReadOptions::Attributes::drawn;
    auto loaded = readGeometry(file, options);
    if (!loaded) stop(loaded.error().sentence());
    const auto cloud = std::make_shared<const PointCloud>(std::move(loaded->geometry.vertices));
    return Octree(cloud).order().size();
}

/// The fewest bytes of work a reader can do: every byte once, into memory that is there.
std::uint64_t plainRead(const std::string& file) {
    const int descriptor = ::open(file.c_str(), O_RDONLY);
    std::vector<char> buffer(4 << 20);
    std::uint64_t bytes = 0;
    for (ssize_t got; (got = ::read(descriptor, buffer.data(), buffer.size())) > 0;)
        bytes += static_cast<std::uint64_t>(got);
    ::close(descriptor);
    return bytes;
}

/// LASzip as its own users call it: one thread, point after point, positions, intensity and colour kept.
std::uint64_t laszip(const std::string& file) {
    laszip_POINTER reader = nullptr;
    laszip_BOOL compressed = 0;
    laszip_header* header = nullptr;
    laszip_point* point = nullptr;
    if (laszip_create(&reader) != 0 || laszip_open_reader(reader, file.c_str(), &compressed) != 0)
        stop("LASzip cannot open the file");
    laszip_get_header_pointer(reader, &header);
    laszip_get_point_pointer(reader, &point);
    const std::uint64_t points = header->number_of_point_records != 0
                                     ? header->number_of_point_records
                                     : header->extended_number_of_point_records;
    std::vector<std::array<float, 3>> places(points);
    std::vector<std::uint16_t> intensity(points);
    std::vector<Color> color(points);
    for (std::uint64_t i = 0; i < points; ++i) {
        if (laszip_read_point(reader) != 0) stop("LASzip cannot read a point");
        places[i] = {static_cast<float>(point->X * header->x_scale_factor),
                     static_cast<float>(point->Y * header->y_scale_factor),
                     static_cast<float>(point->Z * header->z_scale_factor)};
        intensity[i] = point->intensity;
        color[i] = {point->rgb[0], point->rgb[1], point->rgb[2]};
    }
    laszip_close_reader(reader);
    laszip_destroy(reader);
    return places.size();
}

/// Memory that is not a file's pages, at its peak so far: VmHWM counts mapped files, too.
long ownMebibytes() {
    std::ifstream status("/proc/self/status");
    long anonymous = 0;
    for (std::string word; status >> word;)
        if (word == "RssAnon:") status >> anonymous;
    return anonymous / 1024;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) stop("usage: load_one PEER FILE");
    const std::string peer = argv[1];
    const std::string file = argv[2];
    const auto begin = std::chrono::steady_clock::now();
    const std::uint64_t count = peer == "ours"       ? ours(file, ReadOptions::Attributes::drawn)
                                : peer == "ours-all" ? ours(file, ReadOptions::Attributes::all)
                                : peer == "preview"  ? previewed(file)
                                : peer == "index"    ? indexed(file)
                                : peer == "read"     ? plainRead(file)
                                : peer == "laszip"   ? laszip(file)
                                                     : 0;
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    std::cout << peer << " " << taken.count() << " s, " << count << ", peak " << usage.ru_maxrss / 1024
              << " MiB, own at the end " << ownMebibytes() << " MiB\n";
    return 0;
}
