#include "ui/view/PointStore.h"

#include <vtkShaderProgram.h>
#include <vtk_glew.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>

namespace vestige {
namespace {

/// Of the pages that may give way, this share goes at once, so that the search for them is rare.
constexpr std::size_t kGiveWay = 8;
constexpr std::size_t kPageBytes = PointStore::kPage * sizeof(PointVertex);

void* bytes(std::size_t offset) {
    return reinterpret_cast<void*>(offset);
}

}  // namespace

static_assert(sizeof(PointVertex) == 16);

PointStore::PointStore(std::size_t mostPoints) : mostPages_(std::max<std::size_t>(1, mostPoints / kPage)) {}

void PointStore::reserve(std::size_t pages) {
    pages = std::min(pages, mostPages_);
    if (pages <= owners_.size()) return;
    for (const Owner& owner : owners_)
        if (owner.places) (*owner.places)[owner.page] = kNowhere;
    owners_.assign(pages, {});
    free_.resize(pages);
    std::iota(free_.rbegin(), free_.rend(), 0U);
    staging_.clear();
    stagedPlaces_.clear();
}

bool PointStore::touch(const Places& places, std::size_t page) {
    const std::uint32_t place = places[page];
    if (place == kNowhere) return false;
    owners_[place].used = now_;
    return true;
}

bool PointStore::makeFree() {
    std::vector<std::uint32_t> idle;
    for (std::uint32_t place = 0; place < owners_.size(); ++place)
        if (owners_[place].places && owners_[place].used < now_) idle.push_back(place);
    if (idle.empty()) return false;
    const std::size_t going = std::max<std::size_t>(1, idle.size() / kGiveWay);
    const auto end = idle.begin() + static_cast<std::ptrdiff_t>(going);
    std::nth_element(idle.begin(), end - 1, idle.end(), [&](std::uint32_t a, std::uint32_t b) {
        return owners_[a].used != owners_[b].used ? owners_[a].used < owners_[b].used : a < b;
    });
    std::sort(idle.begin(), end, std::greater<>());
    for (auto place = idle.begin(); place != end; ++place) {
        Owner& owner = owners_[*place];
        (*owner.places)[owner.page] = kNowhere;
        owner = {};
        free_.push_back(*place);
    }
    return true;
}

std::uint32_t PointStore::add(Places& places, std::size_t page) {
    if (free_.empty() && !makeFree()) return kNowhere;
    const std::uint32_t place = free_.back();
    free_.pop_back();
    owners_[place] = {&places, page, now_};
    places[page] = place;
    const auto number = static_cast<std::uint32_t>(stagedPlaces_.size());
    stagedPlaces_.push_back(place);
    staging_.resize((std::size_t{number} + 1) * kPage);
    return number;
}

void PointStore::drop(Places& places) {
    for (std::uint32_t& place : places) {
        if (place == kNowhere) continue;
        owners_[place] = {};
        free_.push_back(place);
        place = kNowhere;
    }
}

void PointStore::upload() {
    if (buffer_ == 0) glGenBuffers(1, &buffer_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    if (allocated_ != owners_.size()) {
        allocated_ = owners_.size();
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(allocated_ * kPageBytes), nullptr,
                     GL_DYNAMIC_DRAW);
    }
    // Neighbouring places that were staged one after the other go over together.
    for (std::size_t first = 0; first < stagedPlaces_.size();) {
        std::size_t last = first + 1;
        while (last < stagedPlaces_.size() && stagedPlaces_[last] == stagedPlaces_[last - 1] + 1) ++last;
        glBufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(stagedPlaces_[first] * kPageBytes),
                        static_cast<GLsizeiptr>((last - first) * kPageBytes),
                        staging_.data() + first * kPage);
        first = last;
    }
    uploaded_ += stagedPlaces_.size() * kPage;
    stagedPlaces_.clear();
    staging_.clear();
}

void PointStore::bind(vtkShaderProgram& program) {
    const bool fresh = arrays_ == 0;
    if (fresh) glGenVertexArrays(1, &arrays_);
    glBindVertexArray(arrays_);
    upload();
    const auto handle = static_cast<unsigned>(program.GetHandle());
    if (!fresh && handle == boundProgram_) return;
    boundProgram_ = handle;
    const auto attribute = [&](const char* name, int count, unsigned type, bool normalised,
                               std::size_t offset) {
        const int location = glGetAttribLocation(handle, name);
        if (location < 0) return;
        glEnableVertexAttribArray(static_cast<unsigned>(location));
        glVertexAttribPointer(static_cast<unsigned>(location), count, type, normalised ? GL_TRUE : GL_FALSE,
                              sizeof(PointVertex), bytes(offset));
    };
    attribute("place", 3, GL_FLOAT, false, offsetof(PointVertex, place));
    attribute("paint", 4, GL_UNSIGNED_BYTE, true, offsetof(PointVertex, paint));
}

void PointStore::unbind() {
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void PointStore::release() {
    if (buffer_) glDeleteBuffers(1, &buffer_);
    if (arrays_) glDeleteVertexArrays(1, &arrays_);
    buffer_ = arrays_ = boundProgram_ = 0;
    allocated_ = 0;
    const std::size_t pages = owners_.size();
    for (const Owner& owner : owners_)
        if (owner.places) (*owner.places)[owner.page] = kNowhere;
    owners_.clear();
    reserve(pages);
}

}  // namespace vestige
