#pragma once

#include <QObject>

namespace vestige {

class Document;
class JobRunner;
class Notices;

/// Has the figures that are found from clouds (cross-sections, volumes) computed as a job after every change
/// that asks for some; the document is measured again when it is done. What was cancelled is taken up at the
/// next change of the case.
class CloudMeasuring : public QObject {
    Q_OBJECT

  public:
    CloudMeasuring(Document& document, JobRunner& jobs, Notices& notices, QObject* parent = nullptr);

  private:
    void follow();

    Document& document_;
    JobRunner& jobs_;
    Notices& notices_;
    bool running_ = false;
    int fruitless_ = 0;  ///< jobs in a row after which there was no less to do
};

}  // namespace vestige
