#include "ui/panels/TableText.h"

#include <gtest/gtest.h>

#include <QStandardItemModel>
#include <QTableView>
#include <QTreeWidget>

namespace vestige {
namespace {

class Table : public testing::Test {
  public:
    Table() : model(3, 3) {
        model.setHorizontalHeaderLabels({"Object", "Tape m", "RE %"});
        const char* cells[3][3] = {
            {"Mirror, left", "0.234", "−0.10"}, {"Wheel", "0.650", "+0.53"}, {"Skid\nmark", "–", "–"}};
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column)
                model.setItem(row, column, new QStandardItem(QString::fromUtf8(cells[row][column])));
        view.setModel(&model);
        view.setSelectionBehavior(QAbstractItemView::SelectRows);
        view.setSelectionMode(QAbstractItemView::ExtendedSelection);
    }
    QStandardItemModel model;
    QTableView view;
};

TEST_F(Table, IsCopiedWithHeadingsUnitsAndPlainNumbers) {
    EXPECT_EQ(tableText(view, false),
              "Object\tTape m\tRE %\nMirror, left\t0.234\t-0.10\nWheel\t0.650\t+0.53\nSkid mark\t\t\n");
}

TEST_F(Table, SelectedRowsAreCopiedAlone) {
    view.selectRow(2);
    view.selectionModel()->select(model.index(1, 0), QItemSelectionModel::Select | QItemSelectionModel::Rows);
    EXPECT_EQ(tableText(view, false), "Object\tTape m\tRE %\nWheel\t0.650\t+0.53\nSkid mark\t\t\n");
    EXPECT_EQ(tableText(view, true).count('\n'), 4);
}

TEST_F(Table, HiddenColumnsStayOut) {
    view.setColumnHidden(1, true);
    EXPECT_EQ(tableText(view, true).section('\n', 0, 0), "Object\tRE %");
}

TEST(TableText, AListHasNoHeadings) {
    QTreeWidget list;
    list.setColumnCount(2);
    list.setHeaderHidden(true);
    list.addTopLevelItem(new QTreeWidgetItem({"aerial", "5.0 M"}));
    EXPECT_EQ(tableText(list, true), "aerial\t5.0 M\n");
}

}  // namespace
}  // namespace vestige
