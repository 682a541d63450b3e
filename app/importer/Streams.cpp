#include "app/importer/Streams.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/base/Result.h"

namespace vestige::importer {

std::span<const std::byte> mapped(int descriptor) {
    // fstat() of some C libraries is a call that takes names of files, which is not allowed here.
    const off_t end = ::lseek(descriptor, 0, SEEK_END);
    if (end < 0)
        throw ErrorException{{ErrorCode::input, "the file cannot be read", {}, std::strerror(errno)}};
    if (end == 0) return {};
    const auto size = static_cast<std::size_t>(end);
    void* data = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
    if (data == MAP_FAILED) throw std::bad_alloc();
    return {static_cast<const std::byte*>(data), size};
}

std::string readAll(int descriptor) {
    std::string all;
    char piece[65536];
    for (;;) {
        const ssize_t got = ::read(descriptor, piece, sizeof(piece));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return all;
        all.append(piece, static_cast<std::size_t>(got));
    }
}

void send(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t wrote = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
        if (wrote < 0 && errno == EINTR) continue;
        if (wrote <= 0) ::_exit(1);
        bytes = bytes.subspan(static_cast<std::size_t>(wrote));
    }
}

}  // namespace vestige::importer
