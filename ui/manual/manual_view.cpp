#include "ui/manual/manual_view.hpp"

#include "ui/style/ui_metrics.hpp"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextTable>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace echotrail {
namespace {

constexpr int picture_width = 680;  // px of every picture, shown at half of it: sharp on a dense screen, too

}  // namespace

ManualView::ManualView(Complete complete, QWidget* parent)
    : QWidget(parent), complete_(std::move(complete)) {
    back_ = new QPushButton(QStringLiteral("←"), this);
    contents_ = new QComboBox(this);
    contents_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    contents_->setMinimumContentsLength(10);
    search_ = new QLineEdit(this);
    search_->setClearButtonEnabled(true);
    browser_ = new QTextBrowser(this);
    browser_->setFrameShape(QFrame::NoFrame);
    browser_->setOpenLinks(false);
    browser_->document()->setDocumentMargin(UiMetrics(font()).pixels(8.0));
    auto* row = new QHBoxLayout;
    const int gap = UiMetrics(font()).pixels(4.0);
    row->setContentsMargins(2 * gap, gap, 2 * gap, 0);
    row->setSpacing(gap);
    row->addWidget(back_);
    row->addWidget(contents_, 1);
    row->addWidget(search_, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    column->setSpacing(gap);
    column->addLayout(row);
    column->addWidget(browser_, 1);
    connect(contents_, &QComboBox::activated, this, [this](int i) { show(contents_->itemData(i).toString()); });
    connect(search_, &QLineEdit::textEdited, this, &ManualView::search);
    connect(browser_, &QTextBrowser::anchorClicked, this, &ManualView::follow);
    connect(back_, &QPushButton::clicked, this, &ManualView::goBack);
    inEveryLanguage(this, [this] {
        back_->setToolTip(tr("Back to the page before"));
        back_->setAccessibleName(back_->toolTip());
        contents_->setAccessibleName(tr("Pages of the manual"));
        search_->setPlaceholderText(tr("Find in the manual"));
        search_->setAccessibleName(search_->placeholderText());
        browser_->setAccessibleName(tr("Manual"));
        refresh();
    });
}

void ManualView::refresh() {
    book_.reset();
    if (!page_.isEmpty()) show(page_, words_);
}

const ManualBook& ManualView::book() {
    if (book_) return *book_;
    complete_(book_.emplace(currentLanguage()));
    contents_->clear();
    for (const ManualPage& page : book_->pages()) contents_->addItem(page.title(), page.name);
    return *book_;
}

void ManualView::show(const QString& name, const QString& words) {
    const ManualPage* page = book().page(name);
    if (!page) page = &book().pages().front();
    if (!page_.isEmpty() && page->name != page_) visited_.append(page_);
    back_->setEnabled(!visited_.isEmpty());
    page_ = page->name;
    words_ = words;
    contents_->setCurrentIndex(contents_->findData(page_));
    showText(page->text);
    // As one word after the other where they do not stand together.
    if (words.isEmpty() || !(browser_->find(words) || browser_->find(words.section(' ', 0, 0)))) return;
    QScrollBar& bar = *browser_->verticalScrollBar();
    bar.setValue(bar.value() + browser_->cursorRect().top() - 2 * fontMetrics().height());
}

void ManualView::showText(const QString& markdown) {
    browser_->document()->setDefaultFont(font());
    browser_->document()->setIndentWidth(UiMetrics(font()).length(16.0));
    browser_->setMarkdown(markdown);
    spaceBlocks();
    for (QTextFrame* frame : browser_->document()->rootFrame()->childFrames()) {
        auto* table = qobject_cast<QTextTable*>(frame);
        if (!table) continue;
        QTextTableFormat format = table->format();
        format.setBorder(0);
        format.setCellPadding(UiMetrics(font()).length(2.0));
        table->setFormat(format);
    }
    fitPictures();
    browser_->moveCursor(QTextCursor::Start);
}

/// Air about headings and between paragraphs, of which Markdown says nothing.
void ManualView::spaceBlocks() {
    const UiMetrics metrics(font());
    for (QTextBlock block = browser_->document()->begin(); block.isValid(); block = block.next()) {
        QTextBlockFormat format = block.blockFormat();
        const bool heading = format.headingLevel() > 0;
        const bool code = format.hasProperty(QTextFormat::BlockCodeFence) || format.nonBreakableLines();
        const bool in_table = QTextCursor(block).currentTable();
        if (code || in_table) continue;
        format.setTopMargin(metrics.length(heading && block.blockNumber() > 0 ? 10.0 : 0.0));
        format.setBottomMargin(metrics.length(block.textList() ? 3.0 : 6.0));
        QTextCursor(block).setBlockFormat(format);
    }
}

/// Pictures are as wide as they were made for, or as there is room.
void ManualView::fitPictures() {
    const double room = browser_->viewport()->width() - 2.0 * browser_->document()->documentMargin();
    const double width = std::max(50.0, std::min(room, UiMetrics(font()).length(picture_width / 2.0)));
    for (QTextBlock block = browser_->document()->begin(); block.isValid(); block = block.next())
        for (auto part = block.begin(); !part.atEnd(); ++part) {
            if (!part.fragment().charFormat().isImageFormat()) continue;
            QTextImageFormat format = part.fragment().charFormat().toImageFormat();
            if (format.width() == width) return;  // so are the others
            format.setWidth(width);
            QTextCursor cursor(browser_->document());
            cursor.setPosition(part.fragment().position());
            cursor.setPosition(part.fragment().position() + part.fragment().length(), QTextCursor::KeepAnchor);
            cursor.setCharFormat(format);
            break;  // one to a paragraph
        }
}

void ManualView::search(const QString& words) {
    if (words.trimmed().isEmpty()) return show(page_);
    QString text = "# " + tr("Found") + "\n\n";
    const QList<ManualHit> hits = book().find(words);
    if (hits.isEmpty()) text += tr("Nothing. Try one word, or a part of it.");
    const QString query = QString::fromLatin1(QUrl::toPercentEncoding(words.simplified()));
    for (const ManualHit& hit : hits)
        text += QStringLiteral("- [%1](manual:%2?%3) %4\n")
                    .arg(hit.title, hit.page, query, hit.excerpt.toHtmlEscaped());
    showText(text);
}

void ManualView::follow(const QUrl& link) {
    if (link.scheme() == "manual") show(link.path(), link.query(QUrl::FullyDecoded));
}

void ManualView::goBack() {
    if (visited_.isEmpty()) return;
    const QString before = visited_.takeLast();
    page_.clear();
    show(before);
}

void ManualView::changeEvent(QEvent* event) {
    const bool look = event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange;
    if (look && !page_.isEmpty()) show(page_, words_);
    QWidget::changeEvent(event);
}

void ManualView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitPictures();
}

}  // namespace echotrail
