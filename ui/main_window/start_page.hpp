#pragma once

#include <QAbstractButton>
#include <QWidget>

class QVBoxLayout;

namespace echotrail {

/// One thing to begin with: a picture, a title, what it is, and its key.
class StartChoice : public QAbstractButton {
    Q_OBJECT

public:
    enum class Picture { Fan, Head, TimeLine, List };

    StartChoice(Picture picture, const QString& title, const QString& text, const QString& fact, const QString& key,
                QWidget* parent = nullptr);
    void setFact(const QString& fact);
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void paintPicture(QPainter& painter, const QRectF& box) const;

    Picture picture_;
    QString title_;
    QString text_;
    QString fact_;
    QString key_;
};

/// What the window shows while no source is open: four choices, the first has the focus.
class StartPage : public QWidget {
    Q_OBJECT

public:
    explicit StartPage(QWidget* parent = nullptr);
    /// Full paths, newest first.
    void setRecent(const QStringList& paths);
    void setCanConnect(bool can) { connect_->setEnabled(can); }
    void focusFirst();

Q_SIGNALS:
    void demonstrationChosen();
    void connectChosen();
    void openChosen();
    void recentChosen(const QString& path);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    StartChoice* demonstration_ = nullptr;
    StartChoice* connect_ = nullptr;
    StartChoice* open_ = nullptr;
    StartChoice* recent_ = nullptr;
    QStringList paths_;
};

}  // namespace echotrail
