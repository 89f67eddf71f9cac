#pragma once

#include <QWidget>

class QLabel;
class QListView;
class QPushButton;

namespace echotrail {

class AlertCentre;

/// The list of alerts: what asks for the operator on top, what is over at the foot. Never a box over the picture.
class AlertsPanel : public QWidget {
    Q_OBJECT

public:
    /// The centre is not owned and must outlive the panel.
    explicit AlertsPanel(AlertCentre& centre, QWidget* parent = nullptr);
    QListView& list() { return *list_; }

Q_SIGNALS:
    /// "2 open · 3 in 10 min", for the dock's title.
    void summaryChanged(const QString& summary);

private:
    void nameAll();
    void showSummary();

    AlertCentre& centre_;
    QListView* list_ = nullptr;
    QLabel* empty_ = nullptr;
    QPushButton* acknowledge_ = nullptr;
    QPushButton* silence_ = nullptr;
};

}  // namespace echotrail
