#include "ui/shell/CloudMeasuring.h"

#include <QPointer>

#include "core/scene/CloudKinds.h"
#include "ui/document/Document.h"
#include "ui/document/Notices.h"
#include "ui/jobs/JobRunner.h"

namespace vestige {
namespace {

/// Clouds may be exchanged while a job works on them; after so many jobs in a row there is another reason.
constexpr int kMostFruitless = 20;

}  // namespace

CloudMeasuring::CloudMeasuring(Document& document, JobRunner& jobs, Notices& notices, QObject* parent)
    : QObject(parent), document_(document), jobs_(jobs), notices_(notices) {
    document_.measureCloudsElsewhere();
    connect(&document_, &Document::changed, this, [this] { follow(); });
}

void CloudMeasuring::follow() {
    const auto& wanted = document_.uncomputed();
    if (wanted.empty()) fruitless_ = 0;
    if (running_ || wanted.empty() || document_.cloudsGivenUp()) return;
    running_ = true;
    jobs_.run<bool>(
        tr("Measuring in the clouds"),
        [scene = document_.state(), wanted](const JobControl& control) -> Result<bool> {
            if (const Status done = computeCloudKinds(scene, wanted, control); !done)
                return fail(done.error());
            return true;
        },
        [self = QPointer(this), asked = wanted.size()](const Result<bool>& done) {
            if (!self) return;
            self->running_ = false;
            self->fruitless_ = self->document_.uncomputed().size() < asked ? 0 : self->fruitless_ + 1;
            if (!done) self->notices_.failed(done.error());
            if (done && self->fruitless_ < kMostFruitless)
                self->document_.measureAgain();
            else
                self->document_.giveUpClouds();
        });
}

}  // namespace vestige
