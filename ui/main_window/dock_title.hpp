#pragma once

#include <QDockWidget>

class QLabel;

namespace echotrail {

/// The head of a dock: its name, what is in it at the moment, and buttons to float and to close it.
class DockTitle : public QWidget {
    Q_OBJECT

public:
    explicit DockTitle(QDockWidget* dock);
    void setSummary(const QString& summary);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QLabel* summary_ = nullptr;
};

/// A dock with such a head; its title is given later, in every language. The object name keys the saved layout.
QDockWidget* makeDock(const QString& object_name, QWidget* content, QWidget* parent);
/// Changes what the head says is in the dock.
void setSummary(QDockWidget* dock, const QString& summary);

}  // namespace echotrail
