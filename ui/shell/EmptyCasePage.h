#pragma once

#include <QWidget>

namespace vestige {

class ActionCatalog;
class Document;
class Notices;

/// What the view's place shows of a case without scans: name it, add them.
class EmptyCasePage : public QWidget {
    Q_OBJECT

  public:
    EmptyCasePage(Document& document, Notices& notices, const ActionCatalog& actions,
                  QWidget* parent = nullptr);
};

}  // namespace vestige
