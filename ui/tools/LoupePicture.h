#pragma once

#include <QImage>
#include <QPointF>
#include <memory>

namespace vestige {

class SceneView;

/// The place round a position of a view, magnified: its points drawn anew and not the picture's pixels
/// enlarged, so that points stand apart that share a pixel of the picture. Colours are those of the view;
/// what is hidden there or cut away is not here either. Takes a few milliseconds whatever the cloud: of
/// points that would cover each other one is drawn, and no more than 60 000 in all, nearest first.
class LoupePicture {
  public:
    LoupePicture();
    ~LoupePicture();

    /// A square of `side_px` pixels with `centre` (in pixels of the view) in its middle; `magnification` is
    /// pixels of the square per pixel of the view.
    QImage draw(const SceneView& view, const QPointF& centre, double magnification, int side_px);

  private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace vestige
