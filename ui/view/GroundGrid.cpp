#include "ui/view/GroundGrid.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

#include "core/pipeline/FrameView.h"
#include "ui/view/PlanGrid.h"
#include "ui/view/SampledRange.h"

namespace vestige {
namespace {

constexpr double kMostLines = 160;
/// Over the noise of a road from the air.
constexpr double kLift_m = 0.02;

struct Lines {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkUnsignedCharArray> colors;

    Lines() {
        points->SetDataTypeToDouble();
        colors->SetNumberOfComponents(3);
    }
    void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, unsigned char grey) {
        const vtkIdType from = points->InsertNextPoint(a.data());
        const vtkIdType to = points->InsertNextPoint(b.data());
        cells->InsertNextCell({from, to});
        for (int c = 0; c < 3; ++c) colors->InsertNextValue(grey);
    }
};

}  // namespace

GroundGrid::GroundGrid() : actor_(vtkSmartPointer<vtkActor>::New()) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetScalarModeToUseCellData();
    mapper->SetColorModeToDirectScalars();
    vtkNew<vtkPolyData> none;
    mapper->SetInputData(none);
    actor_->SetMapper(mapper);
    actor_->GetProperty()->LightingOff();
    actor_->VisibilityOff();
    actor_->UseBoundsOff();
}

GroundGrid::~GroundGrid() = default;

void GroundGrid::show(const ViewDescription& view, const Eigen::Vector3d& displayOrigin) {
    on_ = view.showGrid;
    actor_->SetVisibility(on_);
    if (!on_) return;
    theme_ = view.theme;
    origin_ = displayOrigin;
    scene_ = subjectBounds(view);
    SampledRange heights;
    for (const std::size_t index : subjectLayers(view)) {
        const ViewLayer& layer = view.layers[index];
        const PointCloud& cloud = layer.geometry->vertices;
        heights.sample(cloud.size(),
                       [&](std::size_t i) { return (layer.worldFromLayer * cloud.point(i)).z(); });
    }
    height_ = heights.empty() ? 0 : heights.quantile(0.05) + kLift_m;
}

void GroundGrid::setCamera(const ViewCamera& camera) {
    const bool shown = on_ && !scene_.empty() && !showsPlan(camera);
    actor_->SetVisibility(shown);
    if (!shown) return;
    const double spacing = gridSpacing_m(camera);
    const double reach = 0.5 * kMostLines * spacing;
    long first[2];
    long last[2];
    for (int axis = 0; axis < 2; ++axis) {
        const double low = std::max(scene_.min[axis], camera.focalPoint[axis] - reach);
        const double high = std::min(scene_.max[axis], camera.focalPoint[axis] + reach);
        if (low > high) return actor_->VisibilityOff();
        first[axis] = std::lround(std::floor(low / spacing));
        last[axis] = std::lround(std::ceil(high / spacing));
    }
    const bool light = theme_ == Theme::light;
    Lines lines;
    const auto grey = [&](long number) -> unsigned char {
        const bool strong = number % 5 == 0;
        return light ? (strong ? 120 : 176) : (strong ? 150 : 92);
    };
    const auto at = [&](long x, long y) -> Eigen::Vector3d {
        return Eigen::Vector3d(static_cast<double>(x) * spacing, static_cast<double>(y) * spacing, height_) -
               origin_;
    };
    for (long x = first[0]; x <= last[0]; ++x) lines.add(at(x, first[1]), at(x, last[1]), grey(x));
    for (long y = first[1]; y <= last[1]; ++y) lines.add(at(first[0], y), at(last[0], y), grey(y));
    vtkNew<vtkPolyData> data;
    data->SetPoints(lines.points);
    data->SetLines(lines.cells);
    data->GetCellData()->SetScalars(lines.colors);
    vtkPolyDataMapper::SafeDownCast(actor_->GetMapper())->SetInputData(data);
}

}  // namespace vestige
