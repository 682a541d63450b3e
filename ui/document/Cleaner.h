#pragma once

#include <QObject>
#include <map>
#include <memory>
#include <string>

#include "core/scene/Cleaning.h"

namespace vestige {

class Document;
class JobRunner;
class Notices;

/// Keeps the layers' data what their cleaning leaves: whenever an edit, undo, redo or an opened case says
/// otherwise, a job takes the points out of a copy; until it is done they are hidden (hiddenSets). Points
/// that come back are there at once. A cleaning of another file is told and not done.
class Cleaner : public QObject {
    Q_OBJECT

  public:
    Cleaner(Document& document, JobRunner& jobs, Notices& notices, QObject* parent = nullptr);

  private:
    struct Pair {
        std::weak_ptr<const LayerData> data;
        std::shared_ptr<const Cleaning> cleaning;
        bool is(const Layer& layer) const { return cleaning == layer.cleaning && data.lock() == layer.data; }
    };
    void follow();
    void followOne(const Layer& layer);
    void start(const Layer& layer, const std::shared_ptr<const LayerData>& loaded);

    Document& document_;
    JobRunner& jobs_;
    Notices& notices_;
    std::map<std::string, Pair> settled_;  ///< seen to belong together, or given up
    std::map<std::string, Pair> asked_;    ///< what a job makes: of these loaded data, by this cleaning
    bool following_ = false;
    bool again_ = false;
};

}  // namespace vestige
