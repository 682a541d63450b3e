#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/pipeline/PointFlags.h"
#include "core/pipeline/ViewRenderer.h"

namespace vestige {

class Document;
class PointSelection;

/// What of the points shown is selected and what is hidden, for the view. Flags are made again only when what
/// they are made of has changed, so that nothing is painted anew without need.
class PointMarks {
  public:
    PointMarks(const Document& document, const PointSelection& selection)
        : document_(document), selection_(selection) {}
    void apply(ViewDescription& view);

  private:
    using Sets = std::vector<std::shared_ptr<const PointSet>>;
    struct Known {
        std::shared_ptr<const LayerData> data;
        Sets sets;
        PointFlags flags;
    };
    static PointFlags flagsOf(Known& known, const std::shared_ptr<const LayerData>& data, Sets sets);

    const Document& document_;
    const PointSelection& selection_;
    std::map<std::string, Known> selected_;
    std::map<std::string, Known> hidden_;
};

}  // namespace vestige
