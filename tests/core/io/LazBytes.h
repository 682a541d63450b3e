#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/io/formats/LazReader.h"

namespace vestige::test {

inline constexpr std::uint64_t kAll = ~std::uint64_t{0};

enum class With { ours, laszip };

struct Points {
    std::vector<LasPoint> read;
    std::string refusal;
};

/// The points of a LAZ file that the checks find no fault with.
class LazBytes {
  public:
    explicit LazBytes(std::string bytes) : bytes_(std::move(bytes)), job_("cloud.laz", control_) {
        try {
            header_ = parseLasHeader(span(), job_);
            plan_ = planLaz(span(), header_, job_, false);
            sound_ = true;
        } catch (const ErrorException& problem) {
            EXPECT_EQ(problem.error.code, ErrorCode::input);
        }
    }
    bool sound() const { return sound_; }
    bool isOurs() const { return !plan_.chunks.empty(); }
    const LazPlan& plan() const { return plan_; }
    std::uint64_t size() const { return header_.points; }
    /// To be changed after the checks.
    std::string& bytes() { return bytes_; }

    Points points(With reader, bool drawn, std::uint64_t begin = 0, std::uint64_t end = kAll) const {
        LazPlan plan = plan_;
        if (reader == With::laszip) plan.chunks.clear();
        Points points;
        std::uint64_t expected = begin;
        try {
            readLazPoints(span(), header_, plan, drawn, begin, std::min(end, size()), job_,
                          [&](std::uint64_t first, std::span<const LasPoint> block) {
                              EXPECT_EQ(first, expected);
                              points.read.insert(points.read.end(), block.begin(), block.end());
                              expected += block.size();
                          });
        } catch (const ErrorException& problem) {
            points.refusal = problem.error.sentence();
        }
        return points;
    }

  private:
    std::span<const std::byte> span() const { return std::as_bytes(std::span(bytes_)); }

    std::string bytes_;
    JobControl control_;
    ReadJob job_;
    LasHeader header_;
    LazPlan plan_;
    bool sound_ = false;
};

}  // namespace vestige::test
