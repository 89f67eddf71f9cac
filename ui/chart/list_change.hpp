#pragma once

#include <QList>
#include <QUndoCommand>
#include <functional>

namespace echotrail {

/// A list as it was and as it is: the lists of marks and areas are short enough to be kept whole.
template <class Item>
class ListChange : public QUndoCommand {
public:
    using Show = std::function<void(const QList<Item>&)>;

    ListChange(const QString& what, QList<Item> before, QList<Item> after, Show show)
        : QUndoCommand(what), before_(std::move(before)), after_(std::move(after)), show_(std::move(show)) {}
    void undo() override { show_(before_); }
    void redo() override { show_(after_); }

private:
    QList<Item> before_;
    QList<Item> after_;
    Show show_;
};

}  // namespace echotrail
