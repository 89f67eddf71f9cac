#pragma once

#include <QAbstractButton>
#include <QWidget>

class QLabel;

namespace echotrail {

/// One thing to begin with: a picture, a title, what it is, and its key.
class StartChoice : public QAbstractButton {
    Q_OBJECT

public:
    enum class Picture { Fan, Head, TimeLine, List };

    explicit StartChoice(Picture picture, QWidget* parent = nullptr);
    /// What it is called, what it is, and its key.
    void setWords(const QString& title, const QString& text, const QString& key);
    void setFact(const QString& fact);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

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
    void nameAll();

    QLabel* heading_ = nullptr;
    StartChoice* demonstration_ = nullptr;
    StartChoice* connect_ = nullptr;
    StartChoice* open_ = nullptr;
    StartChoice* recent_ = nullptr;
    QStringList paths_;
};

}  // namespace echotrail
