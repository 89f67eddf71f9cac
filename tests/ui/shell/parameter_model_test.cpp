#include "ui/forms/parameter_model.hpp"

#include "core/pipelines/scanning_sonar_pipeline.hpp"
#include "sample_parameters.hpp"
#include "ui/forms/parameter_filter.hpp"
#include "ui/forms/parameter_presets.hpp"
#include "ui/forms/parameter_set.hpp"
#include "ui/forms/parameter_spin_box.hpp"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QDir>
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

TEST_F(ParameterModelTest, AChangeIsSentUntilItIsKnownToBeInForce) {
    const auto state = [&](std::size_t i) { return model_.indexOf(i, ParameterModel::State).data().toString(); };
    model_.setData(model_.indexOf(0), "14");
    EXPECT_EQ(model_.sentCount(), 1);
    EXPECT_TRUE(state(0).contains("sent"));
    EXPECT_EQ(state(1), "");
    model_.confirmSent();
    EXPECT_EQ(model_.sentCount(), 0);
    EXPECT_TRUE(state(0).contains("in force"));
    model_.setData(model_.indexOf(1), "4");
    model_.confirmSent(false);
    EXPECT_EQ(state(1), "changed") << "nothing runs that could say so";
}

TEST_F(ParameterModelTest, WhatTheTrackerDidNotTakeSaysSo) {
    const auto before = model_.values();
    model_.setData(model_.indexOf(0), "14");
    model_.setData(model_.indexOf(1), "4");
    auto aboard = before;
    aboard[1] = 4;
    model_.showValues(aboard);
    EXPECT_TRUE(model_.indexOf(0).data(ParameterModel::Refusal).toString().contains("14 was not taken"));
    EXPECT_TRUE(model_.indexOf(0, ParameterModel::State).data().toString().contains("refused"));
    EXPECT_TRUE(model_.indexOf(1).data(ParameterModel::Refusal).toString().isEmpty());
    EXPECT_TRUE(model_.indexOf(1, ParameterModel::State).data().toString().contains("in force"));
    EXPECT_EQ(threshold(), 12.0);
}

TEST_F(ParameterModelTest, IsComparedWithAPresetInPlaceOfTheDefaults) {
    const auto title = [&] { return model_.headerData(ParameterModel::Default, Qt::Horizontal).toString(); };
    auto preset = model_.values();
    preset[0] = 20.0;
    model_.setReference("deep", preset);
    EXPECT_EQ(title(), "deep");
    EXPECT_EQ(model_.changedCount(), 1);
    EXPECT_EQ(model_.indexOf(0, ParameterModel::Default).data().toString(), "20");
    model_.reset(model_.indexOf(0));
    EXPECT_EQ(threshold(), 20.0) << "taken over";
    EXPECT_EQ(model_.changedCount(), 0);
    model_.clearReference();
    EXPECT_EQ(title(), "Default");
    EXPECT_EQ(model_.changedCount(), 1) << "it differs from the default now";
    model_.resetAll();
    EXPECT_EQ(threshold(), 12.0);
}

TEST_F(ParameterModelTest, FavouritesAreKeptByNameAndFiltered) {
    int told = 0;
    QObject::connect(&model_, &ParameterModel::favouritesChanged, [&] { ++told; });
    model_.setFavourite(model_.indexOf(4), true);
    model_.setFavourite(model_.index(0, 0), true);
    EXPECT_EQ(model_.favourites(), QStringList{"gate_m"}) << "a stage is none";
    EXPECT_EQ(told, 1);
    ParameterFilter filter;
    filter.setSourceModel(&model_);
    const Tester filter_tester(&filter, Tester::FailureReportingMode::Fatal);
    filter.setFavouritesOnly(true);
    ASSERT_EQ(filter.rowCount(), 1);
    EXPECT_EQ(filter.index(0, 0).data().toString(), "Tracking");
    model_.setFavourites({"looks", "of another version"});
    EXPECT_EQ(model_.favourites(), QStringList{"looks"});
    EXPECT_EQ(filter.index(0, 0).data().toString(), "Detection");
}

class ParameterPresetsTest : public ParameterModelTest {
protected:
    QTemporaryDir folder_;
    ParameterPresets presets_{{{"careful", "threshold_db = 20\n"}, {"broken", "threshold_db = 99\n"}},
                              folder_.filePath("presets")};
};

TEST_F(ParameterPresetsTest, SetWhatTheyMentionAndLeaveTheRest) {
    model_.setData(model_.indexOf(1), "5");
    const auto read = presets_.read("careful", model_.infos(), model_.values());
    ASSERT_TRUE(read) << read.error();
    EXPECT_EQ(std::get<double>((*read)[0]), 20.0);
    EXPECT_EQ(std::get<int>((*read)[1]), 5);
    const auto broken = presets_.read("broken", model_.infos(), model_.values());
    ASSERT_FALSE(broken);
    EXPECT_NE(broken.error().find("broken:1: threshold_db"), std::string::npos) << broken.error();
    EXPECT_FALSE(presets_.read("nobody's", model_.infos(), model_.values()));
}

TEST_F(ParameterPresetsTest, OnesOwnAreKeptAndReplaced) {
    EXPECT_TRUE(presets_.own().isEmpty());
    model_.setData(model_.indexOf(0), "14");
    ASSERT_TRUE(presets_.save("harbour deep", model_.infos(), model_.values()));
    model_.setData(model_.indexOf(0), "15");
    ASSERT_TRUE(presets_.save("harbour deep", model_.infos(), model_.values()));
    EXPECT_EQ(presets_.own(), QStringList{"harbour deep"});
    EXPECT_EQ(*presets_.read("harbour deep", model_.infos(), {model_.values()}), model_.values());
}

TEST_F(ParameterPresetsTest, ANameCannotLeadOutOfTheFolderNorHideABuiltInOne) {
    for (const char* name : {"", "../escape", "a/b", ".hidden", "careful", "nul\nline"})
        EXPECT_FALSE(presets_.save(name, model_.infos(), model_.values())) << name;
    EXPECT_FALSE(presets_.save(QString(41, 'a'), model_.infos(), model_.values()));
    EXPECT_TRUE(presets_.own().isEmpty());
    EXPECT_FALSE(QFile::exists(folder_.filePath("escape.toml")));
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
