#include "ui/panels/AlignPanel.h"

#include <QAction>
#include <QCheckBox>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "core/scene/Edits.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/document/Document.h"
#include "ui/document/Notices.h"
#include "ui/forms/ParameterForm.h"
#include "ui/panels/ActionButtons.h"
#include "ui/panels/LayerForm.h"
#include "ui/panels/PanelSection.h"

namespace vestige {
AlignPanel::AlignPanel(Document& document, Selection& selection, Notices& notices,
                       const ActionCatalog& actions, QWidget* parent)
    : QWidget(parent),
      document_(document),
      preprocess_(new ParameterForm(document.state().preprocess.table(),
                                    std::vector<std::string>{"filter", "voxel_m"})),
      registration_(new ParameterForm(document.state().registration.table(),
                                      std::vector<std::string>{"method", "preset"})) {
    auto* content = new QWidget;
    content->setObjectName("panel-content");
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 6, 0, 6);
    column->setSpacing(6);
    addSection(*column, tr("Layer"), new LayerForm(document, selection));
    addSection(*column, tr("Registration"), registration_);
    addSection(*column, tr("Denoise and downsample"), preprocess_);
    column->addStretch(1);
    auto* scroll = new QScrollArea;
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);

    auto* run = buttonFor(actions["register.run"]);
    run->setProperty("role", "primary");

    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(scroll, 1);
    auto* foot = new QHBoxLayout;
    foot->setContentsMargins(12, 6, 12, 12);
    foot->setSpacing(12);
    foot->addWidget(checkBoxFor(actions["register.watch"]));
    foot->addWidget(run, 1);
    whole->addLayout(foot);

    connect(preprocess_, &ParameterForm::edited, this, [this](const std::string& key, const auto& value) {
        document_.perform(setPreprocessParameter(key, value));
    });
    connect(registration_, &ParameterForm::edited, this, [this](const std::string& key, const auto& value) {
        document_.perform(setRegistrationParameter(key, value));
    });
    for (ParameterForm* form : {preprocess_, registration_})
        connect(form, &ParameterForm::refused, &notices,
                [&notices](const QString& sentence) { emit notices.warned(sentence + "."); });
    const auto fill = [this] {
        preprocess_->setValues(document_.state().preprocess);
        registration_->setValues(document_.state().registration);
    };
    connect(&document_, &Document::changed, this, fill);
    fill();
}

}  // namespace vestige
