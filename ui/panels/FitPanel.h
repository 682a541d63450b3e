#pragma once

#include <QTimer>
#include <QWidget>

class QLabel;
class QPushButton;
class QTreeWidget;

namespace vestige {

class ActionCatalog;
class Attempts;
class CompactList;
class Document;
class FiguresRow;
class FitTrace;
class FitTraceView;
class PanelSection;
class Preview;
class ResidualView;
class Selection;
class VerdictBadge;
struct ShownFit;

/// What the registration of the selected layer (else of the last registered one) says of itself: verdict and
/// reasons, candidates to choose from, uncertainty, what the data leave free, residuals, iterations.
class FitPanel : public QWidget {
    Q_OBJECT

  public:
    /// What the panel shows; `attempts` takes the choice of a candidate.
    struct Models {
        Document& document;
        Selection& selection;
        Attempts& attempts;
        FitTrace& trace;
        const Preview& preview;
    };
    FitPanel(const Models& models, const ActionCatalog& actions, QWidget* parent = nullptr);

  private:
    void fill();
    void fillCandidates(const ShownFit& fit);
    void fillQuality(const ShownFit& fit);

    Models models_;
    QLabel* empty_;
    QWidget* content_;
    QLabel* layer_;
    VerdictBadge* badge_;
    QLabel* reasons_;
    QWidget* refused_;
    PanelSection* candidatesSection_;
    CompactList* candidates_;
    QPushButton* useCandidate_;
    PanelSection* uncertaintySection_;
    QLabel* uncertainty_;
    PanelSection* freedomSection_;
    QLabel* freedom_;
    QWidget* arrows_;
    FiguresRow* figures_;
    ResidualView* residuals_;
    QLabel* restarts_;
    FitTraceView* trace_;
    QTimer wanted_;  ///< the iterations are to be seen
};

}  // namespace vestige
