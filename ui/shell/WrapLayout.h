#pragma once

#include <QLayout>
#include <vector>

namespace vestige {

/// Widgets beside each other in rows: one that has no room begins the next row. Lines that divide groups
/// (addGap) are left out where a row begins or ends.
class WrapLayout : public QLayout {
    Q_OBJECT

  public:
    explicit WrapLayout(QWidget* parent);
    ~WrapLayout() override;

    void addGap(QWidget* line);

    void addItem(QLayoutItem* item) override;
    int count() const override { return static_cast<int>(items_.size()); }
    QLayoutItem* itemAt(int index) const override;
    QLayoutItem* takeAt(int index) override;
    QSize sizeHint() const override;  ///< in one row
    QSize minimumSize() const override;
    bool hasHeightForWidth() const override { return true; }
    /// Of all rows, no wider than the widest of them.
    QSize sizeWithin(int width) const { return arranged(QRect(0, 0, width, 0), false); }
    int heightForWidth(int width) const override { return arranged(QRect(0, 0, width, 0), false).height(); }
    Qt::Orientations expandingDirections() const override { return {}; }
    void setGeometry(const QRect& place) override;

  private:
    struct Item {
        QLayoutItem* item;
        bool gap = false;
    };
    QSize arranged(const QRect& place, bool apply) const;

    std::vector<Item> items_;
    bool addingGap_ = false;
};

}  // namespace vestige
