#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

class vtkShaderProgram;

namespace vestige {

/// A point as the graphics card has it: 16 bytes.
struct PointVertex {
    Eigen::Vector3f place;  ///< display frame, metres
    std::array<std::uint8_t, 4> paint;
};

/// The points that the graphics card holds, of all layers of a drawing, in pages of 256: a cache of fixed
/// size whose least recently drawn pages give way. What is put in waits here until flush() hands it over.
class PointStore {
  public:
    static constexpr std::uint32_t kPage = 256;
    static constexpr std::uint32_t kNowhere = std::numeric_limits<std::uint32_t>::max();

    /// Where the pages of one layer lie; by the layer's own page numbers.
    using Places = std::vector<std::uint32_t>;

    explicit PointStore(std::size_t mostPoints);

    /// Makes room for that many pages, up to the most. Growing drops what is held: pages are gone then.
    void reserve(std::size_t pages);
    std::size_t capacity() const { return owners_.size(); }
    /// Points handed to the graphics card since the beginning.
    std::uint64_t uploadedPoints() const { return uploaded_; }
    std::size_t pagesHeld() const { return owners_.size() - free_.size(); }

    /// From here on pages count as used anew: those not touched since may give way.
    void begin() { ++now_; }
    /// Whether page `page` is held; it then stays until the next begin().
    bool touch(const Places& places, std::size_t page);
    /// Finds a place for a page that is not held and notes it in `places`, which must outlive it (see drop).
    /// The vertices to fill, kPage of them, are staged(number). kNowhere where all that is held is in use.
    std::uint32_t add(Places& places, std::size_t page);
    PointVertex* staged(std::uint32_t number) { return staging_.data() + std::size_t{number} * kPage; }
    /// Forgets the pages of a layer; needs no graphics context.
    void drop(Places& places);

    /// Hands over what was added and binds buffer and attributes ("place", "paint") of the program. The
    /// graphics context is current in these three.
    void bind(vtkShaderProgram& program);
    void unbind();
    void release();

  private:
    struct Owner {
        Places* places = nullptr;
        std::size_t page = 0;
        std::uint64_t used = 0;
    };
    bool makeFree();
    void upload();

    std::size_t mostPages_;
    std::vector<Owner> owners_;        ///< by place
    std::vector<std::uint32_t> free_;  ///< places, the last is taken next
    std::vector<PointVertex> staging_;
    std::vector<std::uint32_t> stagedPlaces_;
    std::uint64_t now_ = 1;
    std::uint64_t uploaded_ = 0;
    unsigned buffer_ = 0;
    unsigned arrays_ = 0;
    unsigned boundProgram_ = 0;
    std::size_t allocated_ = 0;  ///< pages of the buffer
};

}  // namespace vestige
