#include "ui/panels/MeasurementsModel.h"

#include <gtest/gtest.h>

#include "core/scene/Edits.h"
#include "ui/document/Document.h"
#include "ui/document/Selection.h"

namespace vestige {
namespace {

/// A case with one layer in metres, which is the target, and one object picked three times on it.
class MeasurementsTable : public testing::Test {
  public:
    MeasurementsTable() {
        Layer layer;
        layer.id = "aerial";
        layer.method = "lidar";
        layer.unit = LengthUnit::metre;
        document.perform(addLayer(layer));
        document.perform(setTarget("aerial"));
        Measurement measurement;
        measurement.object = "mirror";
        document.perform(setMeasurement(measurement, "add mirror"));
        for (const double end : {0.24, 0.25, 0.26})
            document.perform(
                addPick("mirror", "aerial", {{"aerial", {0, 0, 0}, 0.01}, {"aerial", {end, 0, 0}, 0.01}}));
        selection.setMethod("lidar");
    }
    QString text(int column) { return model.data(model.index(0, column), Qt::DisplayRole).toString(); }
    bool type(int column, const QString& value) {
        return model.setData(model.index(0, column), value, Qt::EditRole);
    }

    Document document;
    Selection selection;
    MeasurementsModel model{document, selection};
};

TEST_F(MeasurementsTable, ShowsMeanUncertaintyAndNoErrorWithoutTape) {
    EXPECT_EQ(model.rowCount(), 1);
    EXPECT_EQ(text(MeasurementsModel::object), "mirror");
    EXPECT_EQ(text(MeasurementsModel::tape), "no tape");
    EXPECT_EQ(text(MeasurementsModel::measured), "0.250");
    EXPECT_NE(text(MeasurementsModel::uncertainty), QString::fromUtf8("–"));
    EXPECT_EQ(text(MeasurementsModel::relativeError), QString::fromUtf8("–"));
}

TEST_F(MeasurementsTable, ATypedTapeGivesTheRelativeErrorAndCanBeUndone) {
    EXPECT_TRUE(type(MeasurementsModel::tape, "0.20"));
    EXPECT_EQ(text(MeasurementsModel::relativeError), "+25.0");
    EXPECT_TRUE(type(MeasurementsModel::tape, "0,25"));
    EXPECT_EQ(text(MeasurementsModel::relativeError), "0.00");
    document.undo();
    document.undo();
    EXPECT_EQ(text(MeasurementsModel::tape), "no tape");
}

TEST_F(MeasurementsTable, RefusesWhatIsNoLength) {
    QString sentence;
    QObject::connect(&model, &MeasurementsModel::refused, [&](const QString& why) { sentence = why; });
    for (const char* wrong : {"long", "-1", "0", "4.7 m"}) {
        sentence.clear();
        EXPECT_FALSE(type(MeasurementsModel::tape, wrong));
        EXPECT_TRUE(sentence.contains(wrong));
    }
}

TEST_F(MeasurementsTable, RenamesAndKeepsTheSelection) {
    selection.setObject("mirror");
    EXPECT_TRUE(type(MeasurementsModel::object, "Right mirror"));
    EXPECT_EQ(selection.object(), "Right mirror");
    EXPECT_EQ(text(MeasurementsModel::measured), "0.250");
    document.undo();
    EXPECT_EQ(text(MeasurementsModel::object), "mirror");
}

TEST_F(MeasurementsTable, OnlyObjectAndTapeAreEdited) {
    for (int column = 0; column < MeasurementsModel::columns; ++column)
        EXPECT_EQ((model.flags(model.index(0, column)) & Qt::ItemIsEditable) != 0,
                  column == MeasurementsModel::object || column == MeasurementsModel::tape);
}

}  // namespace
}  // namespace vestige
