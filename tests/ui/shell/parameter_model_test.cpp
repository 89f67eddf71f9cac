#include "ui/forms/parameter_model.hpp"

#include "core/pipelines/scanning_sonar_pipeline.hpp"
#include "sample_parameters.hpp"
#include "ui/forms/parameter_filter.hpp"
#include "ui/forms/parameter_set.hpp"
#include "ui/forms/parameter_spin_box.hpp"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QFile>
#include <QTemporaryDir>

namespace echotrail {
namespace {

using Tester = QAbstractItemModelTester;

class ParameterModelTest : public testing::Test {
protected:
    ParameterModelTest() {
        QObject::connect(&model_, &ParameterModel::valuesChanged, [this] { ++announced_; });
        QObject::connect(&model_, &ParameterModel::refused, [this](const QString& reason) { reason_ = reason; });
    }
    double threshold() const { return std::get<double>(model_.values()[0]); }

    ParameterModel model_{test::sampleParameters()};
    Tester tester_{&model_, Tester::FailureReportingMode::Fatal};
    int announced_ = 0;
    QString reason_;
};

TEST_F(ParameterModelTest, GrowsATreeOfStagesFromTheDescriptions) {
    ASSERT_EQ(model_.rowCount(), 2);
    EXPECT_EQ(model_.index(0, 0).data().toString(), "Detection");
    EXPECT_EQ(model_.rowCount(model_.index(0, 0)), 4);
    EXPECT_EQ(model_.indexOf(4, ParameterModel::Name).data().toString(), "Gate");
    EXPECT_EQ(model_.indexOf(4, ParameterModel::Unit).data().toString(), "m");
    EXPECT_EQ(model_.indexOf(4).data(ParameterModel::Limits).toString(), "0 … 50 m");
}

TEST_F(ParameterModelTest, AnnouncesAChangeOnceAndMarksIt) {
    EXPECT_TRUE(model_.setData(model_.indexOf(0), "14.5"));
    EXPECT_EQ(threshold(), 14.5);
    EXPECT_EQ(announced_, 1);
    EXPECT_TRUE(model_.indexOf(0).data(ParameterModel::Changed).toBool());
    EXPECT_EQ(model_.index(0, 0).data(ParameterModel::Changed).toInt(), 1);
    EXPECT_TRUE(model_.setData(model_.indexOf(0), "14.5")) << "the same again";
    EXPECT_EQ(announced_, 1);
}

TEST_F(ParameterModelTest, TakesNumbersAsPeopleTypeThem) {
    for (const char* typed : {" 14,5 ", "14.5", "1.45e1"}) {
        EXPECT_TRUE(model_.setData(model_.indexOf(0), typed)) << typed;
        EXPECT_EQ(threshold(), 14.5) << typed;
        model_.undoStack().undo();
    }
}

TEST_F(ParameterModelTest, RefusesWithAReasonAndChangesNothing) {
    for (const char* typed : {"99", "-1", "many", "", "nan", "1e999"}) {
        EXPECT_FALSE(model_.setData(model_.indexOf(0), typed)) << typed;
        EXPECT_FALSE(model_.indexOf(0).data(ParameterModel::Refusal).toString().isEmpty()) << typed;
    }
    EXPECT_TRUE(reason_.contains("3 to 40")) << reason_.toStdString();
    EXPECT_FALSE(model_.setData(model_.indexOf(1), "2.5")) << "looks are whole";
    EXPECT_EQ(threshold(), 12.0);
    EXPECT_EQ(announced_, 0);
    EXPECT_TRUE(model_.setData(model_.indexOf(0), "13"));
    EXPECT_TRUE(model_.indexOf(0).data(ParameterModel::Refusal).toString().isEmpty());
}

TEST_F(ParameterModelTest, UndoAndRedoAnnounceWhatIsInForce) {
    model_.setData(model_.indexOf(0), "14");
    model_.setData(model_.indexOf(4), "3");
    model_.undoStack().undo();
    EXPECT_EQ(std::get<double>(model_.values()[4]), 2.5);
    model_.undoStack().undo();
    EXPECT_EQ(threshold(), 12.0);
    model_.undoStack().redo();
    EXPECT_EQ(threshold(), 14.0);
    EXPECT_EQ(announced_, 5);
}

TEST_F(ParameterModelTest, ResettingAllIsOneStepBack) {
    model_.setData(model_.indexOf(0), "14");
    model_.setData(model_.indexOf(2), Qt::Unchecked, Qt::CheckStateRole);
    model_.setData(model_.indexOf(3), "careful");
    EXPECT_EQ(model_.changedCount(), 3);
    model_.resetAll();
    EXPECT_EQ(model_.changedCount(), 0);
    model_.undoStack().undo();
    EXPECT_EQ(model_.changedCount(), 3);
    model_.reset(model_.indexOf(3));
    EXPECT_EQ(model_.changedCount(), 2);
}

TEST_F(ParameterModelTest, ASetGoesThroughAFileUnchanged) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("set.toml");
    model_.setData(model_.indexOf(0), "14.25");
    model_.setData(model_.indexOf(3), "careful");
    ASSERT_TRUE(writeParameterSet(path, model_.infos(), model_.values()));
    const ParameterModel fresh(test::sampleParameters());
    const auto read = readParameterSet(path, fresh.infos(), fresh.values());
    ASSERT_TRUE(read) << read.error();
    EXPECT_EQ(*read, model_.values());
}

TEST_F(ParameterModelTest, ABadFileIsRefusedWithItsLine) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("set.toml");
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("looks = 4\nthreshold_db = 99\n");
    file.close();
    const auto read = readParameterSet(path, model_.infos(), model_.values());
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().find(":2: threshold_db"), std::string::npos) << read.error();
    EXPECT_FALSE(writeParameterSet(folder.filePath("no/such/folder.toml"), model_.infos(), model_.values()));
}

TEST_F(ParameterModelTest, TheFilterFindsByEveryWordAndByChange) {
    ParameterFilter filter;
    filter.setSourceModel(&model_);
    const Tester filter_tester(&filter, Tester::FailureReportingMode::Fatal);
    filter.setSearch("track looks");
    ASSERT_EQ(filter.rowCount(), 1);
    EXPECT_EQ(filter.rowCount(filter.index(0, 0)), 1) << "only the one whose help says both";
    filter.setSearch("");
    filter.setChangedOnly(true);
    EXPECT_EQ(filter.rowCount(), 0);
    model_.setData(model_.indexOf(4), "3");
    ASSERT_EQ(filter.rowCount(), 1);
    EXPECT_EQ(filter.index(0, 0).data().toString(), "Tracking");
    model_.undoStack().undo();
    EXPECT_EQ(filter.rowCount(), 0);
}

TEST(ParameterModelOfThePipeline, HasANameForTheEyeAndAUniqueOneForFiles) {
    const ParameterModel model(describeParameters<ScanningSonarPipeline::Params>());
    QStringList plain;
    for (std::size_t i = 0; i < model.infos().size(); ++i) {
        const QModelIndex row = model.indexOf(i, ParameterModel::Name);
        EXPECT_FALSE(row.data().toString().isEmpty());
        EXPECT_FALSE(row.data(Qt::ToolTipRole).toString().isEmpty());
        plain << row.data(ParameterModel::PlainName).toString();
    }
    EXPECT_EQ(plain.removeDuplicates(), 0);
}

TEST(ParameterSteps, AreHandyAndStayOnTheirGrid) {
    EXPECT_EQ(handyStep(0, 100, false), 1.0);
    EXPECT_EQ(handyStep(3, 40, false), 0.2);
    EXPECT_EQ(handyStep(1, 10, true), 1.0);
    ParameterSpinBox box(3, 40, false);
    box.setTypedText("14.3");
    box.stepBy(1);
    EXPECT_EQ(box.typedText(), "14.4");
    box.stepBy(-2);
    EXPECT_EQ(box.typedText(), "14");
    box.stepBy(-1000);
    EXPECT_EQ(box.typedText(), "3");
}

}  // namespace
}  // namespace echotrail
