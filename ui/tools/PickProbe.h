#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "ui/tools/HoverProbe.h"
#include "ui/tools/ProbedPlace.h"
#include "ui/tools/SnapWorker.h"

namespace vestige {

class Document;
class PickChoices;

/// Answers what a click would take, for every tool that picks: the measured point under the cursor and, as
/// chosen, the feature fitted round it. Hovering asks at most some 25 times a second; features are fitted
/// away from the GUI thread.
class PickProbe : public QObject {
    Q_OBJECT

  public:
    using Done = std::function<void(const ProbedPlace&)>;

    PickProbe(Document& document, const PickChoices& choices, HoverProbe& hover, QObject* parent = nullptr);
    ~PickProbe() override;

    /// The cursor moved with no button down; `hovered` answers in a while.
    void hover(SceneView& view, const QMouseEvent& event);
    /// The same answer again, after what is shown or chosen has changed.
    void renew();
    /// No more answers to what was asked, hovering or clicking.
    void stop();

    /// What a click at `position` takes: at once where nothing must be fitted. Clicks are answered in their
    /// order.
    void take(SceneView& view, const QPoint& position, Done done);
    /// What a click would take while something is dragged to `position`: like hovering, only the last
    /// question of a while is answered.
    void follow(SceneView& view, const QPoint& position, Done done);

  signals:
    void hovered(const ProbedPlace& place);
    /// The cursor has left the view it hovered over.
    void left();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    struct Question;
    std::shared_ptr<const Question> question(SceneView& view, ProbedPlace& place) const;
    void ask(SceneView& view, const QPoint& position, const std::optional<Pick>& under, Done done,
             bool passing);
    ProbedPlace answered(const Question& question, ProbedPlace place,
                         const Result<FittedFeature>& feature) const;

    Document& document_;
    const PickChoices& choices_;
    HoverProbe& probe_;
    SceneView* view_ = nullptr;  ///< where the cursor hovers; null while it does not
    QTimer followTimer_;
    std::function<void()> following_;
    int generation_ = 0;  ///< answers to what was asked before stop() are not wanted
    int serial_ = 0;      ///< of the last question that was asked in passing
    int answeredSerial_ = -1;
    std::shared_ptr<const Question> last_;
    std::optional<Result<FittedFeature>> lastFeature_;
    SnapWorker worker_;
};

}  // namespace vestige
