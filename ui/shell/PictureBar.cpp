#include "ui/shell/PictureBar.h"

#include <QAction>
#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "core/geometry/CameraProjection.h"
#include "core/pipeline/ScaledCamera.h"
#include "core/scene/SceneInputs.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/actions/FileChooser.h"
#include "ui/document/Document.h"
#include "ui/document/Notices.h"
#include "ui/document/Wording.h"
#include "ui/jobs/JobRunner.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {
constexpr double kWindow_dpi = 96;
}  // namespace

PictureBar::PictureBar(const Workbench& bench, SceneView& view, QWidget* parent)
    : ViewBar(bench.actions, "view.screenshot", tr("Picture"), "picture-bar", parent),
      bench_(bench),
      view_(view),
      toScale_(new QCheckBox(tr("True to scale, 1 :"))),
      transparent_(new QCheckBox(tr("No background"))),
      shows_(barLabel({})) {
    width_ =
        numberField(tr("Width of the picture"), "px", tr("Width, 16 to 32000 pixels"), 16, 32000, 0, 100);
    height_ =
        numberField(tr("Height of the picture"), "px", tr("Height, 16 to 32000 pixels"), 16, 32000, 0, 100);
    scale_ = numberField(tr("Scale of the picture, 1 to"), {},
                         tr("100: a metre of the scene is a centimetre on paper. The view is drawn parallel"),
                         0.1, 1e6, 1, 10);
    dpi_ =
        numberField(tr("Dots per inch"), "dpi",
                    tr("Dots per inch, 36 to 2400: written into the file; letters and points grow with them"),
                    36, 2400, 0, 50);
    width_->setObjectName("picture-width");
    height_->setObjectName("picture-height");
    scale_->setObjectName("picture-scale");
    dpi_->setObjectName("picture-dpi");
    toScale_->setObjectName("picture-to-scale");
    transparent_->setObjectName("picture-transparent");
    toScale_->setToolTip(tr("One length in the picture is one length in the scene, wherever it lies"));
    transparent_->setToolTip(tr("Where nothing is drawn the picture is transparent"));
    width_->setValue(2800);
    height_->setValue(1800);
    scale_->setValue(100);
    dpi_->setValue(300);
    auto* saveButton = new QPushButton(tr("Save picture…"));
    saveButton->setObjectName("picture-save");
    saveButton->setProperty("role", "primary");
    saveButton->setToolTip(tr("Choose a PNG file and draw the view into it"));
    grid().addWidget(barLabel(tr("Size")), 0, 0);
    grid().addWidget(width_, 0, 1);
    grid().addWidget(height_, 0, 2);
    grid().addWidget(dpi_, 0, 3);
    grid().addWidget(toScale_, 1, 0, 1, 2);
    grid().addWidget(scale_, 1, 2);
    grid().addWidget(transparent_, 1, 3);
    grid().addWidget(shows_, 2, 0, 1, 3);
    grid().addWidget(saveButton, 2, 3);
    for (QDoubleSpinBox* field : {width_, height_, scale_, dpi_})
        connect(field, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this] { follow(); });
    connect(toScale_, &QCheckBox::toggled, this, [this] { follow(); });
    connect(saveButton, &QPushButton::clicked, this, [this] { save(); });
    follow();
}

void PictureBar::follow() {
    scale_->setEnabled(toScale_->isChecked());
    if (!toScale_->isChecked())
        return shows_->setText(tr("%1 × %2 cm on paper")
                                   .arg(2.54 * width_->value() / dpi_->value(), 0, 'f', 1)
                                   .arg(2.54 * height_->value() / dpi_->value(), 0, 'f', 1));
    const double metre = pixelsPerMetre(scale_->value(), dpi_->value());
    shows_->setText(tr("shows %1 × %2 m on %3 × %4 cm")
                        .arg(width_->value() / metre, 0, 'f', 2)
                        .arg(height_->value() / metre, 0, 'f', 2)
                        .arg(2.54 * width_->value() / dpi_->value(), 0, 'f', 1)
                        .arg(2.54 * height_->value() / dpi_->value(), 0, 'f', 1));
}

ViewDescription PictureBar::described() const {
    ViewDescription view = view_.description();
    view.camera =
        resized(view_.camera(), static_cast<int>(width_->value()), static_cast<int>(height_->value()));
    view.scale.dpi = dpi_->value();
    view.transparent = transparent_->isChecked();
    view.pointSize_px *= std::max(1.0, dpi_->value() / kWindow_dpi);
    if (toScale_->isChecked()) {
        view.scale.denominator = scale_->value();
        view.camera = atScale(view.camera, scale_->value(), dpi_->value());
    }
    return view;
}

void PictureBar::save() {
    if (!bench_.renderer) return bench_.notices.warn(tr("This program has nothing to draw pictures with."));
    const QString file = bench_.chooser->pictureToSave(&bench_.window, bench_.document.title() + ".png");
    if (file.isEmpty()) return;
    const std::filesystem::path path =
        toPath(file.endsWith(".png", Qt::CaseInsensitive) ? file : file + ".png");
    if (const Status apart = isNoInput(bench_.document.state(), path); !apart)
        return bench_.notices.failed(apart.error());
    bench_.jobs.run<int>(
        tr("Drawing the picture"),
        [view = described(), path, renderer = bench_.renderer](const JobControl& control) -> Result<int> {
            if (const Status drawn = renderer->renderPng(view, path, control); !drawn)
                return fail(drawn.error());
            return view.camera.width_px;
        },
        [this, path](Result<int> drawn) {
            if (!drawn) return bench_.notices.failed(drawn.error());
            bench_.notices.informOf(tr("The picture is in %1.").arg(toQt(path.filename())), toQt(path));
        });
}

}  // namespace vestige
