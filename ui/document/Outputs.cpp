#include "ui/document/Outputs.h"

#include <algorithm>

#include "ui/document/Document.h"

namespace vestige {

Outputs::Outputs(Document& document, QObject* parent) : QObject(parent), document_(document) {
    connect(&document_, &Document::replaced, this, [this] {
        all_.clear();
        emit changed();
    });
}

void Outputs::add(Kind kind, const QString& path) {
    all_.insert(all_.begin(), {kind, path, QDateTime::currentDateTime(), document_.step()});
    emit changed();
}

bool Outputs::reported() const {
    return std::any_of(all_.begin(), all_.end(), [this](const Output& output) {
        return output.kind == Kind::report && output.step == document_.step();
    });
}

}  // namespace vestige
