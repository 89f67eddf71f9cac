#include "ui/forms/parameter_form.hpp"

#include "sample_parameters.hpp"
#include "ui/forms/parameter_spin_box.hpp"

#include <gtest/gtest.h>

#include <QLabel>
#include <QTest>
#include <QTreeView>
#include <QWheelEvent>

namespace echotrail {
namespace {

class ParameterFormTest : public testing::Test {
protected:
    ParameterFormTest() {
        QObject::connect(&model_, &ParameterModel::valuesChanged, [this] { ++announced_; });
        form_.resize(600, 700);
        form_.show();
        QTest::qWait(1);
    }

    /// Opens the editor of a parameter as a click on its row does.
    ParameterSpinBox* edit(int row) {
        const auto& view_model = *form_.tree().model();
        form_.tree().setCurrentIndex(view_model.index(row, ParameterModel::Value, view_model.index(0, 0)));
        QTest::qWait(1);
        auto* field = form_.tree().findChild<ParameterSpinBox*>();
        if (field) field->setFocus();
        return field;
    }
    double threshold() const { return std::get<double>(model_.values()[0]); }

    ParameterModel model_{test::sampleParameters()};
    ParameterForm form_{model_};
    int announced_ = 0;
};

TEST_F(ParameterFormTest, TypingCommitsNothingUntilEnterAndThenOnce) {
    auto* field = edit(0);
    ASSERT_NE(field, nullptr);
    field->selectAll();
    QTest::keyClicks(field, "13.45");
    EXPECT_EQ(announced_, 0);
    QTest::keyClick(field, Qt::Key_Return);
    QTest::qWait(1);
    EXPECT_EQ(announced_, 1);
    EXPECT_EQ(threshold(), 13.45);
}

TEST_F(ParameterFormTest, LeavingTheFieldCommitsOnce) {
    auto* field = edit(0);
    ASSERT_NE(field, nullptr);
    field->selectAll();
    QTest::keyClicks(field, "13");
    edit(1);
    EXPECT_EQ(announced_, 1);
    EXPECT_EQ(threshold(), 13.0);
}

TEST_F(ParameterFormTest, EscLeavesTheValueAsItWas) {
    auto* field = edit(0);
    ASSERT_NE(field, nullptr);
    field->selectAll();
    QTest::keyClicks(field, "13");
    QTest::keyClick(field, Qt::Key_Escape);
    QTest::qWait(1);
    EXPECT_EQ(announced_, 0);
    EXPECT_EQ(threshold(), 12.0);
}

TEST_F(ParameterFormTest, AStepCommitsAtOnceAndUndoTakesItBack) {
    auto* field = edit(0);
    ASSERT_NE(field, nullptr);
    QTest::keyClick(field, Qt::Key_Up);
    EXPECT_EQ(announced_, 1);
    EXPECT_GT(threshold(), 12.0);
    model_.undoStack().undo();
    EXPECT_EQ(threshold(), 12.0);
}

TEST_F(ParameterFormTest, ARefusalShowsItsReasonInTheForm) {
    auto* field = edit(0);
    ASSERT_NE(field, nullptr);
    field->selectAll();
    QTest::keyClicks(field, "99");
    QTest::keyClick(field, Qt::Key_Return);
    QTest::qWait(1);
    EXPECT_EQ(announced_, 0);
    auto* refusal = form_.findChild<QLabel*>("refusal");
    ASSERT_NE(refusal, nullptr);
    EXPECT_TRUE(refusal->isVisible());
    EXPECT_TRUE(refusal->text().contains("3 to 40")) << refusal->text().toStdString();
}

TEST_F(ParameterFormTest, TheWheelChangesNothingWithoutFocus) {
    auto* field = edit(0);
    ASSERT_NE(field, nullptr);
    const auto turn = [&] {
        QWheelEvent event({5, 5}, field->mapToGlobal(QPointF(5, 5)), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(field, &event);
    };
    field->clearFocus();
    turn();
    EXPECT_EQ(announced_, 0);
}

TEST_F(ParameterFormTest, AClickTurnsASwitch) {
    const auto& view_model = *form_.tree().model();
    const QModelIndex value = view_model.index(2, ParameterModel::Value, view_model.index(0, 0));
    QTest::mouseClick(form_.tree().viewport(), Qt::LeftButton, {}, form_.tree().visualRect(value).center());
    QTest::qWait(1);
    EXPECT_EQ(announced_, 1);
    EXPECT_FALSE(std::get<bool>(model_.values()[2]));
}

TEST_F(ParameterFormTest, AClickOnTheStarMakesAFavourite) {
    const auto& view_model = *form_.tree().model();
    const QModelIndex star = view_model.index(1, ParameterModel::Star, view_model.index(0, 0));
    QTest::mouseClick(form_.tree().viewport(), Qt::LeftButton, {}, form_.tree().visualRect(star).center());
    EXPECT_EQ(model_.favourites(), QStringList{"looks"});
    EXPECT_EQ(announced_, 0);
    QTest::qWait(1);
    form_.toggleFavourite();
    EXPECT_TRUE(model_.favourites().isEmpty()) << "by key, of the row in hand";
}

TEST(ParameterFormPresets, AreTakenTakenBackAndComparedWith) {
    ParameterModel model(test::sampleParameters());
    ParameterForm form(model, ParameterPresets({{"deep", "threshold_db = 20\nlooks = 3\n"}}, {}));
    QString said;
    QObject::connect(&form, &ParameterForm::message, [&](const QString& text, bool) { said = text; });
    form.show();
    form.compareWith("deep");
    EXPECT_EQ(model.changedCount(), 1);
    const auto& view_model = *form.tree().model();
    ASSERT_EQ(view_model.rowCount(), 1) << "only what differs is shown";
    EXPECT_EQ(view_model.rowCount(view_model.index(0, 0)), 1);
    form.takePreset("deep");
    EXPECT_EQ(std::get<double>(model.values()[0]), 20.0);
    EXPECT_EQ(model.changedCount(), 0);
    model.undoStack().undo();
    EXPECT_EQ(std::get<double>(model.values()[0]), 12.0);
    form.compareWith({});
    EXPECT_EQ(model.changedCount(), 0);
    form.takePreset("shallow");
    EXPECT_TRUE(said.contains("was not taken")) << said.toStdString();
    form.savePreset("mine");
    EXPECT_TRUE(said.contains("Not kept")) << "there is no folder";
}

}  // namespace
}  // namespace echotrail
