#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace echotrail {

/// One line over the picture's edge that says what happened and what to do next. It never takes the focus and never
/// asks to be answered; a notice leaves by itself when the next thing is done, a problem stays until it is closed.
class MessageStrip : public QFrame {
    Q_OBJECT

public:
    enum class Kind { Notice, Problem };

    explicit MessageStrip(QWidget* parent = nullptr);
    void say(Kind kind, const QString& text);
    /// Something is under way that can be broken off.
    void sayBusy(const QString& text);
    void clear();
    QString text() const;

Q_SIGNALS:
    void cancelled();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void nameButton();

    Kind kind_ = Kind::Notice;
    QLabel* label_ = nullptr;
    QPushButton* button_ = nullptr;
    bool busy_ = false;
};

}  // namespace echotrail
