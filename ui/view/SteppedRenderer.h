#pragma once

#include <QImage>
#include <optional>

#include "core/pipeline/ViewRenderer.h"

namespace vestige {

/// A renderer that draws a picture in steps, so that a window on the same thread goes on answering. The steps
/// depend on the description alone: the picture is the same on every run.
class SteppedRenderer : public ViewRenderer {
  public:
    /// Begins a picture; one that was begun and is not whole is given up. `place` is for the error.
    virtual Status begin(const ViewDescription& view, const std::string& place) = 0;
    /// Draws some of it: the picture once it is whole, nothing before.
    virtual std::optional<Result<QImage>> step() = 0;
    /// Of the picture, 0 to 1.
    virtual double share() const = 0;
};

}  // namespace vestige
