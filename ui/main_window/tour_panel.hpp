#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace echotrail {

/// Three things to try, one after the other, beside the running console: never in its way, left at any time.
class TourPanel : public QWidget {
    Q_OBJECT

public:
    enum Step { Designate, Mark, Change, StepCount };

    explicit TourPanel(QWidget* parent = nullptr);
    void start();
    /// The operator has done what a step asks for, wherever the tour is; it says so and waits for "next".
    void did(Step step);
    int step() const { return step_; }

Q_SIGNALS:
    /// It was gone through or left.
    void ended();

private:
    void showStep();
    void goTo(int step);

    int step_ = 0;
    bool done_[StepCount] = {};
    QLabel* title_ = nullptr;
    QLabel* text_ = nullptr;
    QLabel* state_ = nullptr;
    QPushButton* back_ = nullptr;
    QPushButton* next_ = nullptr;
    QPushButton* leave_ = nullptr;
};

}  // namespace echotrail
