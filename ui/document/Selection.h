#pragma once

#include <QObject>
#include <string>

namespace vestige {

/// What the user works on: a layer, an object to measure, the method whose figures are shown. Not part of the
/// case, so no edits. Empty: nothing.
class Selection : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;
    const std::string& layer() const { return layer_; }
    const std::string& object() const { return object_; }
    const std::string& method() const { return method_; }

    void setLayer(std::string id) { set(layer_, std::move(id)); }
    void setObject(std::string object) { set(object_, std::move(object)); }
    void setMethod(std::string method) { set(method_, std::move(method)); }

  signals:
    void changed();

  private:
    void set(std::string& field, std::string value) {
        if (field == value) return;
        field = std::move(value);
        emit changed();
    }

    std::string layer_;
    std::string object_;
    std::string method_;
};

}  // namespace vestige
