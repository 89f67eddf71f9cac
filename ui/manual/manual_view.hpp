#pragma once

#include "ui/manual/manual_book.hpp"

#include <QWidget>
#include <functional>
#include <optional>

class QComboBox;
class QLineEdit;
class QPushButton;
class QTextBrowser;
class QUrl;

namespace echotrail {

/// The manual: a list of its pages, a field to search them, and the page.
class ManualView : public QWidget {
    Q_OBJECT

public:
    /// What the program knows of itself, added to the book whenever the language has changed.
    using Complete = std::function<void(ManualBook&)>;

    explicit ManualView(Complete complete, QWidget* parent = nullptr);
    /// Opens a page, at the first place of these words where there are any. An unknown name opens the first page.
    void show(const QString& page, const QString& words = {});
    /// The program has changed what it would add: the book is made anew when it is opened, or at once where it is.
    void refresh();
    QString page() const { return page_; }
    const ManualBook& book();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void showText(const QString& markdown);
    void spaceBlocks();
    void fitPictures();
    void search(const QString& words);
    void follow(const QUrl& link);
    void goBack();

    Complete complete_;
    std::optional<ManualBook> book_;  ///< made when it is first opened
    QString page_;
    QString words_;
    QStringList visited_;
    QComboBox* contents_ = nullptr;
    QLineEdit* search_ = nullptr;
    QPushButton* back_ = nullptr;
    QTextBrowser* browser_ = nullptr;
};

}  // namespace echotrail
