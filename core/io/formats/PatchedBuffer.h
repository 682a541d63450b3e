#pragma once

#include <cstddef>
#include <span>
#include <streambuf>
#include <utility>
#include <vector>

namespace vestige {

/// Whether the arithmetic decoder of LASzip would begin with a code that is not below its range, which no
/// encoder writes: it would then read beyond its tables.
inline bool beginsBeyondRange(std::span<const std::byte> code) {
    constexpr std::byte kAll{0xff};
    return code.size() >= 4 && code[0] == kAll && code[1] == kAll && code[2] == kAll && code[3] == kAll;
}

/// A stream over a file in memory whose beginning is replaced by `prefix`. LASzip reads in bulk what is
/// plain, and byte by byte what its decoder takes: where it goes over to single bytes, a code that is beyond
/// the decoder's range ends the stream.
class PatchedBuffer : public std::streambuf {
  public:
    PatchedBuffer(std::vector<std::byte> prefix, std::span<const std::byte> file)
        : prefix_(std::move(prefix)), file_(file) {
        show(prefix_, 0);
    }

  protected:
    int_type underflow() override {
        const std::size_t place = position();
        if (place >= file_.size()) return traits_type::eof();
        if (afterBulk_ && beginsBeyondRange(file_.subspan(place))) return traits_type::eof();
        seek(place);
        return traits_type::to_int_type(*gptr());
    }
    std::streamsize xsgetn(char* to, std::streamsize wanted) override {
        seek(position());
        const std::streamsize got = std::streambuf::xsgetn(to, wanted);
        // Nothing is at hand now, so that the next single byte asks underflow().
        setg(eback(), gptr(), gptr());
        afterBulk_ = true;
        return got;
    }
    pos_type seekoff(off_type offset, std::ios_base::seekdir direction, std::ios_base::openmode) override {
        const off_type base = direction == std::ios_base::beg   ? 0
                              : direction == std::ios_base::cur ? static_cast<off_type>(position())
                                                                : static_cast<off_type>(file_.size());
        const off_type target = base + offset;
        if (target < 0 || target > static_cast<off_type>(file_.size())) return pos_type(off_type(-1));
        seek(static_cast<std::size_t>(target));
        return target;
    }
    pos_type seekpos(pos_type position, std::ios_base::openmode mode) override {
        return seekoff(off_type(position), std::ios_base::beg, mode);
    }

  private:
    std::size_t position() const { return shownFrom_ + static_cast<std::size_t>(gptr() - eback()); }

    void seek(std::size_t place) {
        afterBulk_ = false;
        if (place < prefix_.size()) {
            show(prefix_, 0);
            skip(place);
        } else {
            show(file_.subspan(prefix_.size()), prefix_.size());
            skip(place - prefix_.size());
        }
    }
    void show(std::span<const std::byte> part, std::size_t from) {
        char* begin = const_cast<char*>(reinterpret_cast<const char*>(part.data()));
        shownFrom_ = from;
        setg(begin, begin, begin + part.size());
    }
    void skip(std::size_t count) { setg(eback(), eback() + count, egptr()); }

    std::vector<std::byte> prefix_;
    std::span<const std::byte> file_;
    std::size_t shownFrom_ = 0;
    bool afterBulk_ = false;
};

}  // namespace vestige
